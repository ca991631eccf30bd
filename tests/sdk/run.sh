#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: tests the client libraries with the cases of conformance.json and with hedgehogd of that build; prints
# the table of libraries and cases at the end.
set -euo pipefail

[ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
build=$(cd -- "$1" && pwd)
daemon=$build/daemon/hedgehogd
cd "$(dirname -- "${BASH_SOURCE[0]}")"
export PYTHONDONTWRITEBYTECODE=1
HEDGEHOG_CONFORMANCE_TABLE=$(mktemp)
export HEDGEHOG_CONFORMANCE_TABLE
trap 'rm -f "$HEDGEHOG_CONFORMANCE_TABLE"' EXIT
export HEDGEHOG_SLOW_NAMES=$build/tests/sdk/slow_names.so
# Terminates a command that hangs, with its child processes; the tests have shorter time limits of their own.
bounded() {
  timeout --kill-after=10 1800 "$@" || {
    local result=$?
    [ "$result" -ne 124 ] || echo "tests/sdk: $1 did not end" >&2
    return "$result"
  }
}
# No request to a registry except for the packages of the lock files.
export npm_config_update_notifier=false
packed=$PWD/../../build/sdk
./pack.sh "$packed"
bounded python3 conformance_table_test.py
bounded python3 python_conformance.py
bounded python3 python_unread.py
bounded python3 python_mdns.py
bounded python3 python_live.py "$daemon"
bounded python3 python_types.py
bounded python3 python_wheel.py "$daemon" "$packed"
# The oldest Python that the library runs with; Debian 12 does not have it.
if [ -n "${PYTHON39:-}" ]; then
  HEDGEHOG_CONFORMANCE_TABLE='' bounded "$PYTHON39" python_conformance.py
  bounded "$PYTHON39" python_live.py "$daemon"
fi

# JavaScript, in Node.js and in the browser of tests/web.
packages=$PWD/../../build/npm
../../cmake/npm.sh ../web "$packages/web"
../../cmake/npm.sh js/types "$packages/typescript"
HEDGEHOGD=$daemon HEDGEHOG_PACKED=$packed HEDGEHOG_NODE_MODULES=$packages/web/node_modules \
  HEDGEHOG_TYPESCRIPT=$packages/typescript/node_modules \
  bounded ../node_test.sh 240000 --test-concurrency=1 --test-reporter=spec js/*.test.mjs

# C#, for Unity and others.
bounded unity/run.sh "$daemon"

# C++.
bounded "$build/tests/sdk/cpp_conformance" "$PWD"
bounded ./cpp_live.sh "$build"

# The sessions that tests/e2e/sessions has recordings of, as the libraries are now.
recorded=$(mktemp -d)
trap 'rm -rf "$HEDGEHOG_CONFORMANCE_TABLE" "$recorded"' EXIT
bounded sessions/record.py "$daemon" "$build/tests/sdk/cpp_session" "$recorded"

# Godot.
bounded godot/run.sh "$daemon"

# Unreal.
bounded unreal/run.sh "$daemon"

# The racer's haptics in each language.
bounded python3 examples_live.py "$daemon" "$packed" "$build/tests/sdk/cpp_racer" ../../build/unreal/live

# The quick starts, the sizes of the libraries, and the table.
bounded ./quick_starts.py "$daemon"
../../cmake/bundle.sh ../../clients/js/src "$packed/client" browser.js
../../cmake/compress.sh "$packed/client"
./sizes.py "$packed" "$packed/client" ../../build/run/share/hedgehog/*
./conformance_table.py "$HEDGEHOG_CONFORMANCE_TABLE"
