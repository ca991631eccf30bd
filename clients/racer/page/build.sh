#!/bin/sh
# SPDX-License-Identifier: MIT
# Bundles the game's page into a folder: build.sh FOLDER. The packages are the dashboard's, by its lock file.
set -eu

here=$(cd -- "$(dirname -- "$0")" && pwd)
root=$(cd -- "$here/../../.." && pwd)
out=${1:?build.sh FOLDER}
packages=$root/build/npm/dashboard

"$root/cmake/npm.sh" "$root/clients/dashboard" "$packages"

mkdir -p "$out"
out=$(cd -- "$out" && pwd)
rm -rf "${out:?}"/*
cd "$here"
NODE_PATH=$packages/node_modules "$packages/node_modules/.bin/esbuild" \
  src/main.js style.css --bundle --format=esm --minify --entry-names='[name]' --legal-comments=eof --log-level=warning \
  --outdir="$out"
cp index.html "$root/clients/dashboard/icon.svg" "$out"
