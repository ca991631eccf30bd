#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the image again, of a copy of the sources, in another folder, and compares the bytes. reproducible.sh DIRECTORY FIRMWARE_IMAGE.
# Exit: 0 identical, 1 different, 64 usage.
set -eu

[ $# -eq 2 ] || { echo "reproducible.sh DIRECTORY FIRMWARE_IMAGE" >&2; exit 64; }
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
image=$(realpath "$2")
built=$(realpath "$1")
mkdir "$again/sources" "$again/built"
(cd "$(dirname -- "$0")/../.." && cp -r --parents firmware daemon/device/board_core tests/firmware/worst_stack.awk "$again/sources")
"$again/sources/firmware/build.sh" "$again/built" "$image" >/dev/null
for name in hedgehog-board.uf2 hedgehog-board.elf hedgehog-board.map; do
  cmp "$built/$name" "$again/built/$name"
done
echo "two builds, the same bytes"
