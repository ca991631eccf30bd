#!/bin/sh
# SPDX-License-Identifier: MIT
# pack.sh OUT: builds the distributed packages of the client libraries without a network: npm's file and Python's wheel.
set -eu

[ $# -eq 1 ] || { echo "pack.sh OUT" >&2; exit 64; }
clients=$(cd -- "$(dirname -- "$0")/../../clients" && pwd)
rm -rf "$1"
mkdir -p "$1"
out=$(cd -- "$1" && pwd)
(cd "$clients/js" && npm pack --pack-destination "$out" --offline --loglevel=error) >/dev/null
# A copy, because the build leaves folders beside the sources.
cp -r "$clients/python" "$out/source"
(cd "$out/source" && pyproject-build --wheel --no-isolation --outdir "$out" .) >"$out/build.log" 2>&1 ||
  { cat "$out/build.log" >&2; exit 1; }
rm -r "$out/source" "$out/build.log"
