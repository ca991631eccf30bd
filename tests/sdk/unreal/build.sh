#!/bin/sh
# SPDX-License-Identifier: MIT
# build.sh OUT: builds the plugin on the stub of the engine, and with it the test programs OUT/conformance and OUT/live. Compiled as
# Unreal does: without exceptions and RTTI, all sources of the module as one. CXX and CXXFLAGS (-std=c++17) select another compiler
# and standard.
set -eu

[ $# -eq 1 ] || { echo "build.sh OUT" >&2; exit 64; }
out=$1
root=$(cd -- "$(dirname -- "$0")/../../.." && pwd)
module=$root/clients/unreal/Source/HedgehogHaptics
here=$root/tests/sdk/unreal

# The engine's headers, and those that its header tool generates.
mkdir -p "$out/engine/Modules" "$out/engine/Stats" "$out/engine/Subsystems"
for header in CoreMinimal Tickable Modules/ModuleManager Stats/Stats Subsystems/GameInstanceSubsystem; do
  echo '#include "tests/sdk/unreal/engine_stub.h"' >"$out/engine/$header.h"
done
for header in AddressInfoTypes IPAddress SocketSubsystem Sockets; do
  echo '#include "tests/sdk/unreal/sockets_stub.h"' >"$out/engine/$header.h"
done
for header in "$module"/Public/*.h; do
  : >"$out/engine/$(basename "$header" .h).generated.h"
done
for source in "$module"/Private/*.cpp "$module"/Private/core/*.cpp; do
  echo "#include \"$source\""
done >"$out/module.cpp"
# The quick start, a member function of the class AMyCar in live.cpp.
# shellcheck disable=SC2016  # the backticks are Markdown's
sed -n '/^```cpp$/,/^```$/p' "$root/clients/unreal/README.md" | sed '1d;/^```$/,$d' >"$out/quick_start.inc"

command -v ccache >/dev/null && cache=ccache || cache=
compile() {
  # shellcheck disable=SC2086  # the flags are words
  $cache "${CXX:-c++}" ${CXXFLAGS:--std=c++17} -fno-exceptions -fno-rtti -Wall -Wextra -Wconversion -Wshadow -Werror \
    -I"$root" -I"$out" -I"$out/engine" -I"$module/Public" -I"$module/Private" -c "$1" -o "$2"
}
compile "$out/module.cpp" "$out/module.o"
compile "$here/engine_stub.cpp" "$out/engine_stub.o"
for program in conformance live; do
  compile "$here/$program.cpp" "$out/$program.o"
  "${CXX:-c++}" -o "$out/$program" "$out/$program.o" "$out/module.o" "$out/engine_stub.o" -pthread
done
