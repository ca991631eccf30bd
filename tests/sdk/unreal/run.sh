#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh HEDGEHOGD: tests the plugin for Unreal with the conformance suite and with that daemon, on a stub of the engine.
set -eu

[ $# -eq 1 ] || { echo "run.sh HEDGEHOGD" >&2; exit 64; }
here=$(cd -- "$(dirname -- "$0")" && pwd)
out=$(cd -- "$here/../../.." && pwd)/build/unreal

export PYTHONDONTWRITEBYTECODE=1
"$here/build.sh" "$out"
"$out/messages"
python3 "$here/conformance.py" "$out/conformance"
python3 "$here/live.py" "$1" "$out/live"
