#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh: tests protocol/schema/openrpc.json with OpenRPC's own tools. Exit: 0 all passed.
set -eu

here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$(cd -- "$here/../.." && pwd)
packages=$root/build/npm/openrpc

"$root/cmake/npm.sh" "$here" "$packages"
HEDGEHOG_NODE_MODULES=$packages/node_modules
export HEDGEHOG_NODE_MODULES
exec node --test "$here/openrpc.test.mjs"
