#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles the board core for a Cortex-M0+ with Debian's gcc, prints its size and its worst stack, and links the
# vectors to the board core of the image, as firmware/build.sh has compiled it in DIRECTORY/board: DIRECTORY/vectors.elf.
# build.sh DIRECTORY. Exit: 0 built, 64 usage, 66 no image, 69 no compiler, else the compiler's.
set -eu

[ $# -eq 1 ] || { echo "build.sh DIRECTORY" >&2; exit 64; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname -- "$0")/../.."
command -v arm-none-eabi-g++ >/dev/null || { echo "build.sh: no arm-none-eabi-g++ (gcc-arm-none-eabi)" >&2; exit 69; }

compile() { # source, object, more options
  source=$1 object=$2
  shift 2
  arm-none-eabi-g++ -std=c++20 -mcpu=cortex-m0plus -mthumb -Os -ffreestanding -nostdinc++ -fno-exceptions -fno-rtti \
    -fno-threadsafe-statics -ffunction-sections -fdata-sections -Wall -Wextra -Wpedantic -Wconversion \
    -Wno-sign-conversion -Wshadow -Werror -I. -c "$source" -o "$object" "$@"
}

rm -rf "$out"/*.o "$out"/*.ci "$out/small"
mkdir "$out/small"
objects=
for source in daemon/device/board_core/*.cpp; do
  name=$(basename "$source" .cpp).o
  [ -e "$out/board/$name" ] || { echo "build.sh: no $out/board/$name (firmware/build.sh)" >&2; exit 66; }
  compile "$source" "$out/small/$name" -fcallgraph-info=su
  objects="$objects $out/board/$name"
done
echo "board core for Cortex-M0+, -Os:"
arm-none-eabi-size -t "$out"/small/*.o | sed "s|$out/small/||"
# The deepest of the runtime's helpers, 64-bit division (100 bytes in the disassembly), uses less than this.
awk -v roots='BoardCore7receive BoardCore4step BoardCore15write_telemetry board8measured board8pins_for' \
  -v runtime=112 -f tests/firmware/worst_stack.awk "$out"/small/*.ci

compile tests/firmware/vectors.cpp "$out/vectors.o"
# Start-up code needs registers and fixed addresses.
compile tests/firmware/cortex_main.cpp "$out/cortex_main.o" -Wno-register -Wno-volatile -fno-tree-loop-distribute-patterns
# shellcheck disable=SC2086
arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb -nostdlib -Wl,--gc-sections -Wl,-T,tests/firmware/cortex.ld \
  "$out"/*.o $objects -lgcc -o "$out/vectors.elf"
