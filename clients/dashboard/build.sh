#!/bin/sh
# SPDX-License-Identifier: MIT
# Bundles the dashboard into a folder: build.sh FOLDER.
set -eu

here=$(cd -- "$(dirname -- "$0")" && pwd)
out=${1:?build.sh FOLDER}
"$here/../../cmake/bundle.sh" "$here" "$out" src/main.js src/orientation.js src/designer.js style.css
cp "$here/index.html" "$here/orientation.html" "$here/designer.html" "$here/icon.svg" "$out"
"$here/../../cmake/compress.sh" "$out"
