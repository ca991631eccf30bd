#!/bin/sh
# SPDX-License-Identifier: MIT
# build.sh OUT [PROJECT]: the plugin over the stub of the engine, and with it the test's programs OUT/conformance, OUT/messages and
# OUT/live. With PROJECT, a game's folder, the plugin in its Plugins/HedgehogHaptics and the sources in its Source/*, as OUT/game. As
# Unreal compiles them: without exceptions and RTTI, all sources of a module as one. CXX and CXXFLAGS (-std=c++17) choose another
# compiler and standard.
set -eu

[ $# -eq 1 ] || [ $# -eq 2 ] || { echo "build.sh OUT [PROJECT]" >&2; exit 64; }
out=$1
project=${2:-}
root=$(cd -- "$(dirname -- "$0")/../../.." && pwd)
here=$root/tests/sdk/unreal
plugin=$root/clients/unreal
if [ -n "$project" ]; then
  project=$(cd -- "$project" && pwd)
  plugin=$project/Plugins/HedgehogHaptics
fi
module=$plugin/Source/HedgehogHaptics

# The engine's headers.
mkdir -p "$out/engine/Engine" "$out/engine/GameFramework" "$out/engine/Modules" "$out/engine/Stats" "$out/engine/Subsystems"
# headers STUB NAME...
headers() {
  stub=$1
  shift
  for header in "$@"; do
    echo "#include \"tests/sdk/unreal/$stub.h\"" >"$out/engine/$header.h"
  done
}
headers engine_stub CoreMinimal Tickable Modules/ModuleManager Stats/Stats Subsystems/GameInstanceSubsystem
headers game_stub Engine/GameInstance GameFramework/Actor
headers sockets_stub AddressInfoTypes IPAddress SocketSubsystem Sockets

# one NAME FOLDER...: OUT/NAME.cpp, the sources in the folders; and the headers that the engine's tool writes for theirs.
one() {
  name=$1
  shift
  : >"$out/$name.cpp"
  for folder in "$@"; do
    for source in "$folder"/*.cpp; do
      [ ! -e "$source" ] || echo "#include \"$source\"" >>"$out/$name.cpp"
    done
    for header in "$folder"/*.h; do
      [ ! -e "$header" ] || : >"$out/engine/$(basename "$header" .h).generated.h"
    done
  done
}
one module "$module/Public" "$module/Private" "$module/Private/core"

command -v ccache >/dev/null && cache=ccache || cache=
# compile SOURCE OBJECT OPTION...
compile() {
  source=$1 object=$2
  shift 2
  # shellcheck disable=SC2086  # the flags are words
  $cache "${CXX:-c++}" ${CXXFLAGS:--std=c++17} -fno-exceptions -fno-rtti -Wall -Wextra -Wconversion -Wshadow -Werror \
    -I"$root" -I"$out/engine" -I"$module/Public" "$@" -c "$source" -o "$object"
}
link() { "${CXX:-c++}" -o "$out/$1" "$out/$1.o" "$out/module.o" "$out/engine_stub.o" -pthread; }
compile "$out/module.cpp" "$out/module.o" -I"$module/Private"
compile "$here/engine_stub.cpp" "$out/engine_stub.o"
if [ -z "$project" ]; then
  for program in conformance live messages; do
    compile "$here/$program.cpp" "$out/$program.o" -I"$module/Private"
    link "$program"
  done
else
  one game "$here/game" "$project"/Source/*
  set -- "$project"/Source/*
  compile "$out/game.cpp" "$out/game.o" "-I$1"
  link game
fi
