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
git clone --quiet --no-checkout . "$again/tree"
git -C "$again/tree" reset --quiet
git ls-files -z | tar --null --files-from=- --create --mtime='2001-09-09 UTC' | tar --extract --directory "$again/tree"
(umask 027 && TZ=Pacific/Auckland LC_ALL=POSIX LANG=de_DE "$again/tree/cmake/deb.sh" "$build" "$again/deb" >/dev/null)
tests/deb/equal.sh "$out" "$again/deb" || { echo "tests/deb: a second packing gives other packages" >&2; exit 1; }
echo "tests/deb: packed twice, equal bytes"
