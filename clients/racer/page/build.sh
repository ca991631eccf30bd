#!/bin/sh
# SPDX-License-Identifier: MIT
# Bundles the game's page into a folder: build.sh FOLDER.
set -eu

here=$(cd -- "$(dirname -- "$0")" && pwd)
out=${1:?build.sh FOLDER}
"$here/../../../cmake/bundle.sh" "$here" "$out" src/main.js style.css
cp "$here/index.html" "$here/../../dashboard/icon.svg" "$out"
"$here/../../../cmake/compress.sh" "$out"
