#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# compiled_again.sh PACKED OUT: compiles what is committed again, in a folder of another name, with another mask, time zone and
# language and without the compiler's cache: every package has the bytes of that in OUT (make deb PACKED=…). The folder is
# build/again, emptied before. Exit: 0 the same, 1 not, 64 usage or changes that are not committed.
set -euo pipefail

[ $# -eq 2 ] || { echo "compiled_again.sh PACKED OUT" >&2; exit 64; }
out=$(cd "$2" && pwd)
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."
[ -z "$(git status --porcelain)" ] || { echo "compiled_again.sh: commit your changes first, or stash them" >&2; exit 64; }
rm -rf build/again
(umask 027 && CCACHE_DISABLE=1 TZ=Pacific/Auckland LC_ALL=POSIX LANG=de_DE cmake/deb_revision.sh HEAD "$PWD/build/again" "$1")
tests/deb/equal.sh "$out" build/again/build/deb || { echo "tests/deb: a second compilation gives other packages" >&2; exit 1; }
echo "tests/deb: compiled twice, equal bytes"
