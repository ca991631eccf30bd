#!/bin/sh
# SPDX-License-Identifier: MIT
# Bundles the dashboard into a folder: build.sh FOLDER. Packages go to build/npm/dashboard, by the lock file.
set -eu

here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$(cd -- "$here/../.." && pwd)
out=${1:?build.sh FOLDER}
packages=$root/build/npm/dashboard

"$root/cmake/npm.sh" "$here" "$packages"

mkdir -p "$out"
out=$(cd -- "$out" && pwd)
rm -rf "${out:?}"/*
cd "$here"
NODE_PATH=$packages/node_modules "$packages/node_modules/.bin/esbuild" \
  src/main.js src/orientation.js style.css --bundle --splitting --format=esm --minify --entry-names='[name]' \
  --chunk-names='[name]-[hash]' --legal-comments=eof --log-level=warning --outdir="$out"
cp index.html orientation.html icon.svg "$out"
