#!/bin/sh
# SPDX-License-Identifier: MIT
# bundle.sh FOLDER OUT ENTRY...: the entries of a page's FOLDER bundled into OUT, emptied before. The packages are the
# dashboard's, by its lock file, in build/npm/dashboard.
set -eu

root=$(cd -- "$(dirname -- "$0")/.." && pwd)
from=$1
mkdir -p "$2"
out=$(cd -- "$2" && pwd)
shift 2
packages=$root/build/npm/dashboard

"$root/cmake/npm.sh" "$root/clients/dashboard" "$packages"

rm -rf "${out:?}"/*
cd "$from"
NODE_PATH=$packages/node_modules "$packages/node_modules/.bin/esbuild" "$@" \
  --bundle --splitting --format=esm --minify --entry-names='[name]' --chunk-names='[name]-[hash]' --legal-comments=eof \
  --log-level=warning --outdir="$out"
