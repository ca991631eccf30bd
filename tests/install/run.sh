#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: installs BUILD into a prefix, moves the prefix, and uses it as a game's developer does. Exit: 0 passed.
set -euo pipefail

[ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
build=$(cd "$1" && pwd)
source=$(cd "$(dirname -- "$0")/../.." && pwd)
work=$(mktemp -d)
daemon=
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  if [ -n "$daemon" ]; then
    kill -KILL "$daemon" 2>/dev/null || true
    wait "$daemon" 2>/dev/null || true
  fi
  rm -rf "$work"
}
trap clean_up EXIT

fail() { echo "tests/install: $*" >&2; exit 1; }
step() { echo "tests/install: $*"; }

step "install"
cmake --install "$build" --prefix "$work/first" >"$work/install.log" || { cat "$work/install.log"; exit 1; }
grep -q "^ExecStart=$work/first/bin/hedgehogd$" "$work/first/lib/systemd/system/hedgehogd.service" ||
  fail "hedgehogd.service names another program"
mv "$work/first" "$work/prefix"
prefix=$work/prefix

step "make install"
make --silent -C "$source" install INSTALLED="$build" DESTDIR="$work/package" PREFIX=/opt/hedgehog >"$work/install.log" ||
  { cat "$work/install.log"; exit 1; }
diff <(cd "$prefix" && find . | sort) <(cd "$work/package/opt/hedgehog" && find . | sort) || fail "make install installs other files"
[ "$(find "$work/package" -not -path "$work/package/opt/hedgehog*" | wc -l)" = 2 ] || fail "make install writes outside PREFIX"
grep -q "^ExecStart=/opt/hedgehog/bin/hedgehogd$" "$work/package/opt/hedgehog/lib/systemd/system/hedgehogd.service" ||
  fail "hedgehogd.service of make install names another program"
! grep -rl "$work" "$work/package" || fail "make install leaves DESTDIR in a file"
rm -r "$work/package"
! make --silent -C "$source" install INSTALLED="$work/none" 2>"$work/install.log" || fail "make install installs what is not built"
grep -q "nothing to install: make release" "$work/install.log" || fail "make install does not say what is missing"

for file in bin/hedgehogd bin/hedgehogctl bin/hedgehog-study bin/hedgehog-design bin/hedgehog-gamepad bin/hedgehog-mqtt bin/hedgehog-orientation \
  bin/hedgehog-racer share/hedgehog/hedgehogd.json share/hedgehog/devices.d/hedgehog-86.json \
  share/hedgehog/patterns/heartbeat.json share/hedgehog/study/speed-jnd.json share/hedgehog/schema/openrpc.json \
  lib/systemd/system/hedgehogd@.service lib/udev/rules.d/60-hedgehog.rules lib/sysusers.d/hedgehog.conf lib/tmpfiles.d/hedgehog.conf \
  share/man/man8/hedgehogd.8 share/man/man1/hedgehogctl.1 share/bash-completion/completions/hedgehogctl \
  share/zsh/site-functions/_hedgehogd share/fish/vendor_completions.d/hedgehog-study.fish \
  include/hedgehog/clients/lib/ball.h share/doc/hedgehog/operate.md share/doc/hedgehog/troubleshooting.md; do
  [ -s "$prefix/$file" ] || fail "$file is not installed"
done
"$source/tests/install/links.sh" "$prefix/share/doc/hedgehog" || fail "the documents' links"

# Each program has completions and a man page of the same name.
for program in "$prefix"/bin/*; do
  name=${program##*/}
  for file in share/bash-completion/completions/"$name" share/zsh/site-functions/_"$name" \
    share/fish/vendor_completions.d/"$name".fish; do
    [ -s "$prefix/$file" ] || fail "$file is not installed"
  done
  [ -s "$prefix/share/man/man1/$name.1" ] || [ -s "$prefix/share/man/man8/$name.8" ] || fail "$name has no man page"
done

if command -v groff >/dev/null; then
  step "man pages"
  for page in "$prefix"/share/man/man?/*; do
    warnings=$(groff -man -ww -z -Tutf8 "$page" 2>&1)
    [ -z "$warnings" ] || fail "$warnings"
  done
fi

step "a daemon of that prefix"
export XDG_RUNTIME_DIR=$work/run XDG_STATE_HOME=$work/state XDG_CONFIG_HOME=$work/config HOME=$work
export HEDGEHOG_PATIENCE_MS=60000 LC_ALL=C.UTF-8
# The first place that clients search, so that they find this daemon before an installed one.
export RUNTIME_DIRECTORY=$work/run/hedgehog
unset HEDGEHOG_ADDRESS STATE_DIRECTORY
mkdir -p "$work/run" "$work/config/hedgehog"
# A device that exists only in this prefix.
cp "$prefix/share/hedgehog/devices.d/hedgehog-86.json" "$prefix/share/hedgehog/devices.d/of-this-prefix.json"
echo '{"device": "of-this-prefix", "http": {"listen": null}}' >"$work/config/hedgehog/hedgehogd.json"
mkfifo "$work/listening"
exec 3<>"$work/listening"
"$prefix/bin/hedgehogd" --simulate --speed 1 --listen 127.0.0.1:0 >"$work/listening" 2>"$work/daemon.log" &
daemon=$!
# The daemon prints a line for each listener, once clients can connect.
read -r -t 120 line <&3 || { cat "$work/daemon.log"; fail "the daemon did not start"; }
step "$line"
[ -S "$RUNTIME_DIRECTORY/hedgehogd.sock" ] || fail "the daemon's socket is not where clients look first"
ctl=$prefix/bin/hedgehogctl
"$ctl" status >/dev/null

awk '/^```cpp$/ { on = 1; next } /^```$/ { if (on) exit } on' "$source/clients/cpp.md" >"$work/game.cpp"
[ -s "$work/game.cpp" ] || fail "clients/cpp.md has no program in C++"
# The quick start: ten lines in an empty folder.
mkdir "$work/empty"
awk '/^```cpp$/ { on = 1; next } /^```$/ { if (on) exit } on' "$source/clients/lib/README.md" >"$work/empty/game.cpp"
lines=$(wc -l <"$work/empty/game.cpp")
if [ "$lines" -lt 5 ] || [ "$lines" -gt 10 ]; then fail "the first program of clients/lib/README.md has $lines lines"; fi

# felt NAME PROGRAM: an effect of the program must end as completed.
felt() {
  local before after
  before=$("$ctl" events --since 1h --types effect_ended --json | grep -c '"reason":"completed"' || true)
  "$2" || fail "$1: the program failed"
  # The effect may outlast the program, and the history is written a moment later.
  for _ in $(seq 300); do
    after=$("$ctl" events --since 1h --types effect_ended --json | grep -c '"reason":"completed"' || true)
    [ "$after" -le "$before" ] || break
    sleep 0.2
  done
  [ "$after" -gt "$before" ] || fail "$1: its crash was not felt"
  step "$1: compiled, run, felt"
}

cmake --no-warn-unused-cli -S "$source/tests/install/game" -B "$work/by-cmake" -DGAME_SOURCE="$work/game.cpp" \
  -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON >"$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
cmake --build "$work/by-cmake" >"$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
felt "find_package(Hedgehog)" "$work/by-cmake/game"

config=$(dirname "$(find "$prefix" -name hedgehog-client.pc)")
# shellcheck disable=SC2046  # flags are words
"${CXX:-c++}" -std=c++20 -Wall -Wextra -Werror "$work/game.cpp" -o "$work/by-pkg-config" \
  $(PKG_CONFIG_PATH="$config" pkg-config --cflags --libs hedgehog-client)
felt "pkg-config" "$work/by-pkg-config"

# shellcheck disable=SC2046  # flags are words
(cd "$work/empty" && "${CXX:-c++}" -std=c++20 -Wall -Wextra -Werror game.cpp -o game \
  $(PKG_CONFIG_PATH="$config" pkg-config --cflags --libs hedgehog-client))
quick_start() {
  local celsius
  celsius=$("$work/empty/game")
  awk -v c="$celsius" 'BEGIN { exit !(c > 10 && c < 60) }'
}
felt "quick start" quick_start

awk '/^```cpp$/ { ++n; next } /^```$/ { if (n == 2) exit; next } n == 2' "$source/clients/cpp.md" >"$work/empty/threaded.cpp"
# shellcheck disable=SC2046  # flags are words
(cd "$work/empty" && "${CXX:-c++}" -std=c++20 -Wall -Wextra -Werror threaded.cpp -o threaded \
  $(PKG_CONFIG_PATH="$config" pkg-config --cflags --libs hedgehog-client))
felt "with a thread" "$work/empty/threaded"

step "the quick start of C++"
PKG_CONFIG_PATH=$config PYTHONDONTWRITEBYTECODE=1 python3 "$source/tests/sdk/quick_starts.py" "$prefix/bin/hedgehogd" C++

# Packages needed only by programs and tests must not be required. CMake uses its module PkgConfig for OpenSSL even without pkg-config.
without="$(printf ' -DCMAKE_DISABLE_FIND_PACKAGE_%s=ON' CLI11 spdlog GTest rapidcheck benchmark) -DPKG_CONFIG_EXECUTABLE=/bin/false"
# shellcheck disable=SC2086
cmake --no-warn-unused-cli -S "$source/tests/install/game" -B "$work/subproject" -G Ninja -DGAME_SOURCE="$work/game.cpp" \
  -DHEDGEHOG_SUBPROJECT="$source" -DHEDGEHOG_UNITY=ON $without >"$work/cmake.log" || { cat "$work/cmake.log"; exit 1; }
cmake --build "$work/subproject" --target game >"$work/cmake.log" || { tail -30 "$work/cmake.log"; exit 1; }
felt "add_subdirectory" "$work/subproject/game"

kill "$daemon"
wait "$daemon" || fail "the daemon did not end as it should"
daemon=
step "all is well"
