#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# cpp_live.sh BUILD: runs the example of clients/examples with the simulated daemon of that build, and without a daemon.
# Exit: 0 passed.
set -euo pipefail

[ $# -eq 1 ] || { echo "cpp_live.sh BUILD" >&2; exit 64; }
build=$(cd -- "$1" && pwd)
work=$(mktemp -d)
daemon=
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [ -z "$daemon" ] || { kill "$daemon" && wait "$daemon"; } 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT
fail() { echo "tests/sdk/cpp_live: $*" >&2; exit 1; }

export HOME=$work XDG_CONFIG_HOME=$work XDG_STATE_HOME=$work XDG_RUNTIME_DIR=$work HEDGEHOG_PATIENCE_MS=60000
# The first place that clients search, so that they find this daemon before an installed one.
export RUNTIME_DIRECTORY=$work/hedgehog
unset HEDGEHOG_ADDRESS STATE_DIRECTORY
nobody=$(HEDGEHOG_ADDRESS=127.0.0.1:1 "$build/tests/sdk/cpp_racer" 2>&1 >/dev/null) && fail "the example plays on nothing"
[ "$nobody" = "the daemon does not run: 127.0.0.1:1: connection refused" ] || fail "nobody there: $nobody"

mkfifo "$work/listening"
exec 3<>"$work/listening"
"$build/daemon/hedgehogd" --simulate --speed 1 --listen 127.0.0.1:0 >"$work/listening" 2>"$work/daemon.log" &
daemon=$!
read -r -t 120 line <&3 || { cat "$work/daemon.log"; fail "the daemon did not start"; }
echo "$line"
"$build/tests/sdk/cpp_racer" || fail "the example"
echo "tests/sdk/cpp_live: all is well"
