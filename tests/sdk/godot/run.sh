#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh HEDGEHOGD: tests the addon for Godot with the conformance suite and with that daemon, without a screen.
set -eu

[ $# -eq 1 ] || { echo "run.sh HEDGEHOGD" >&2; exit 64; }
here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$(cd -- "$here/../../.." && pwd)
packages=$root/build/npm/gdscript

export PYTHONDONTWRITEBYTECODE=1
python3 "$here/conformance.py"
python3 "$here/live.py" "$1"
"$root/cmake/npm.sh" "$here" "$packages"
HEDGEHOG_NODE_MODULES=$packages/node_modules
export HEDGEHOG_NODE_MODULES
node --test --test-reporter=spec "$here/syntax.test.mjs"
