#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# reproducible.sh BUILD OUT: packs BUILD again in another folder, with another umask, time zone and locale, and compares every
# package byte by byte with that in OUT, which cmake/deb.sh packed from the same tree.
set -euo pipefail

[ $# -eq 2 ] || { echo "reproducible.sh BUILD OUT" >&2; exit 64; }
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
(umask 027 && TZ=Pacific/Auckland LC_ALL=POSIX LANG=de_DE "$here/../../cmake/deb.sh" "$1" "$again" >/dev/null)
"$here/equal.sh" "$2" "$again" || { echo "tests/deb: a second packing gives other packages" >&2; exit 1; }
echo "tests/deb: packed twice, equal bytes"
