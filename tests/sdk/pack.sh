#!/bin/sh
# SPDX-License-Identifier: MIT
# pack.sh OUT: builds the distributed packages of the client libraries without a network: npm's file and Python's wheel.
set -eu

[ $# -eq 1 ] || { echo "pack.sh OUT" >&2; exit 64; }
here=$(cd -- "$(dirname -- "$0")" && pwd)
clients=$here/../../clients
rm -rf "$1"
mkdir -p "$1"
out=$(cd -- "$1" && pwd)
# Copies, because the pages of a package differ, and a build leaves folders beside the sources.
cp -r "$clients/js" "$out/js"
"$here/packed_pages.py" "$clients/js" "$out/js" connection.md
(cd "$out/js" && npm pack --pack-destination "$out" --offline --loglevel=error) >/dev/null
cp -r "$clients/python" "$out/python"
"$here/packed_pages.py" "$clients/python" "$out/python"
(cd "$out/python" && pyproject-build --wheel --no-isolation --outdir "$out" .) >"$out/build.log" 2>&1 ||
  { cat "$out/build.log" >&2; exit 1; }
rm -r "$out/js" "$out/python" "$out/build.log"
