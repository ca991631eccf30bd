#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# reproducible.sh BUILD OUT: packs BUILD again in another folder, from a copy of the tree with older files, with another umask, time
# zone and locale, and compares every package byte by byte with that in OUT, which cmake/deb.sh packed from the same tree.
set -euo pipefail

[ $# -eq 2 ] || { echo "reproducible.sh BUILD OUT" >&2; exit 64; }
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "$1" && pwd)
out=$(cd "$2" && pwd)
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
cd "$here/../.."
tree=.
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  tree=$again/tree
  git clone --quiet --no-checkout . "$tree"
  cp "$(git rev-parse --git-path index)" "$tree/.git/index"
  git ls-files -z | tar --null --files-from=- --create --mtime='2001-09-09 UTC' | tar --extract --directory "$tree"
fi
(umask 027 && TZ=Pacific/Auckland LC_ALL=POSIX LANG=de_DE "$tree/cmake/deb.sh" "$build" "$again/deb" >/dev/null)
tests/deb/equal.sh "$out" "$again/deb" || { echo "tests/deb: a second packing gives other packages" >&2; exit 1; }
echo "tests/deb: packed twice, equal bytes"
