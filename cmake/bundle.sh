#!/bin/sh
# SPDX-License-Identifier: MIT
# bundle.sh FOLDER OUT ENTRY...: bundles the entries of a page's FOLDER into OUT, which is emptied first. The packages are
# those of the dashboard's lock file, in build/npm/dashboard.
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
