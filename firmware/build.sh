#!/bin/sh
# SPDX-License-Identifier: MIT
# The firmware of the reference board with Debian's gcc: DIRECTORY/hedgehog-board.uf2, .elf, .map, and its sizes and worst
# stack. build.sh DIRECTORY FIRMWARE_IMAGE [CALIBRATION]: the last in place of firmware/calibration.h.
# Exit: 0 built, 1 the stack may be too small, 64 usage, 66 no such calibration, 69 no compiler, else the compiler's.
set -eu

[ $# -eq 2 ] || [ $# -eq 3 ] || { echo "build.sh DIRECTORY FIRMWARE_IMAGE [CALIBRATION]" >&2; exit 64; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
calibration=${3:-$(dirname -- "$0")/calibration.h}
[ -r "$calibration" ] || { echo "build.sh: no $calibration" >&2; exit 66; }
calibration=$(realpath "$calibration")
image=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
cd "$(dirname -- "$0")/.."
command -v arm-none-eabi-g++ >/dev/null || { echo "build.sh: no arm-none-eabi-g++ (gcc-arm-none-eabi)" >&2; exit 69; }

export LC_ALL=C
# An image of before must not be taken for the one that was refused; until the new one is complete, a test may be running it.
rm -rf "$out/board"
trap 'rm -f "$out/hedgehog-board.uf2" "$out/hedgehog-board.elf" "$out/hedgehog-board.map"' EXIT
mkdir -p "$out/board/include/firmware"
cp "$calibration" "$out/board/include/firmware/calibration.h"
objects=
for source in daemon/device/board_core/*.cpp firmware/*.cpp firmware/usb/*.cpp; do
  object=$out/board/$(basename "$source" .cpp).o
  # The same bytes wherever it is built. Registers and addresses are what start-up code is made of.
  (cd "$out/board" && arm-none-eabi-g++ -std=c++20 -mcpu=cortex-m0plus -mthumb -O2 -g -ffreestanding -nostdinc++ \
    -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections \
    -fno-tree-loop-distribute-patterns "-ffile-prefix-map=$OLDPWD=." "-ffile-prefix-map=$out/board=." \
    -fcallgraph-info=su -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow -Werror \
    -Iinclude "-I$OLDPWD" \
    -c "$OLDPWD/$source" -o "$(basename "$object")")
  objects="$objects $(basename "$object")"
done
# shellcheck disable=SC2086
(cd "$out/board" && arm-none-eabi-g++ -mcpu=cortex-m0plus -mthumb -nostdlib -Wl,--gc-sections -Wl,--fatal-warnings \
  -Wl,--no-warn-rwx-segments "-Wl,-Map=hedgehog-board.map" "-Wl,-T,$OLDPWD/firmware/board.ld" $objects -lgcc -o board.elf)

arm-none-eabi-objcopy -O binary --only-section=.boot2 "$out/board/board.elf" "$out/board/boot2.bin"
"$image" boot2 "$out/board/boot2.bin" "$out/board/boot2.crc"
arm-none-eabi-objcopy --update-section ".boot2=$out/board/boot2.crc" "$out/board/board.elf" "$out/board/hedgehog-board.elf"
arm-none-eabi-objcopy -O binary "$out/board/hedgehog-board.elf" "$out/board/board.bin"
"$image" uf2 "$out/board/board.bin" "$out/board/hedgehog-board.uf2"

echo "firmware of the reference board:"
arm-none-eabi-size -A "$out/board/hedgehog-board.elf" | awk '
  $1 == ".boot2" || $1 == ".start" || $1 == ".image" { flash += $2 }
  $1 == ".image" || $1 == ".bss" { ram += $2 }
  END { printf "flash %d bytes of 2097152, RAM %d bytes of 266240 (the program is in it), stack of 4096:\n", flash, ram }'
# The calls through pointers are the one of `board_main`, and those into the ROM, which never return.
rm "$out/board/startup.ci" "$out/board/boot_loader.ci"
# The runtime's helpers as in tests/firmware/build.sh. A quarter of the stack at most: an overflow cannot be handled.
awk -v roots=board_main -v runtime=112 -v most=1024 -f tests/firmware/worst_stack.awk "$out"/board/*.ci

mv "$out/board/hedgehog-board.uf2" "$out/board/hedgehog-board.elf" "$out/board/hedgehog-board.map" "$out"
trap - EXIT
