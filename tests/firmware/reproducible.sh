#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the image again in another folder and compares the bytes. reproducible.sh DIRECTORY FIRMWARE_IMAGE.
# Exit: 0 identical, 1 different, 64 usage.
set -eu

[ $# -eq 2 ] || { echo "reproducible.sh DIRECTORY FIRMWARE_IMAGE" >&2; exit 64; }
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
"$(dirname -- "$0")/../../firmware/build.sh" "$again" "$2" >/dev/null
for name in hedgehog-board.uf2 hedgehog-board.elf; do
  cmp "$1/$name" "$again/$name"
done
echo "two builds, the same bytes"
