#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh BUILD: hedgehogd of that build with JSON-RPC clients from npm. Exit: 0 all passed.
set -eu

[ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
HEDGEHOGD=$(cd -- "$1" && pwd)/daemon/hedgehogd
here=$(cd -- "$(dirname -- "$0")" && pwd)
packages=$(cd -- "$here/../.." && pwd)/build/npm/json_rpc

"$here/../../cmake/npm.sh" "$here" "$packages"
HEDGEHOG_NODE_MODULES=$packages/node_modules
export HEDGEHOGD HEDGEHOG_NODE_MODULES
exec node --test --test-timeout=240000 "$here/json_rpc.test.mjs"
