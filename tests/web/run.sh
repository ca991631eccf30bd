#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh BUILD [shots FOLDER]: the pages of that build in a browser, tested or drawn. BUILD has the programs and,
# in share/hedgehog/www and share/hedgehog/racer, the pages.
set -eu

here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$(cd -- "$here/../.." && pwd)
build=$(cd -- "${1:?run.sh BUILD}" && pwd)
packages=$root/build/npm/web

"$root/cmake/npm.sh" "$here" "$packages"
HEDGEHOGD=$build/daemon/hedgehogd
HEDGEHOG_RACER=$build/clients/racer/hedgehog-racer
HEDGEHOG_NODE_MODULES=$packages/node_modules
export HEDGEHOGD HEDGEHOG_RACER HEDGEHOG_NODE_MODULES
if [ "${2-}" = shots ]; then
  exec node "$here/shots.mjs" "${3:?run.sh BUILD shots FOLDER}"
fi
exec node --test --test-concurrency=1 --test-timeout=480000 "$here"/*.test.mjs
