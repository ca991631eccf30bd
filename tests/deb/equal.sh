#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# equal.sh OUT OTHER: whether both folders have the same packages, byte by byte; prints what differs. Exit: 0 the same, 1 not.
set -euo pipefail

[ $# -eq 2 ] || { echo "equal.sh OUT OTHER" >&2; exit 64; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
names() { find "$1" -maxdepth 1 -name '*.deb' -printf '%f\n' | sort; }
code=0
diff <(names "$1") <(names "$2") || code=1
[ -n "$(names "$1")" ] || { echo "equal.sh: $1 has no packages" >&2; exit 1; }
for package in "$1"/*.deb; do
  other=$2/${package##*/}
  if [ ! -e "$other" ] || cmp "$package" "$other"; then continue; fi
  code=1
  rm -rf "${work:?}"/*
  dpkg-deb --raw-extract "$package" "$work/one"
  dpkg-deb --raw-extract "$other" "$work/other"
  diff --recursive --brief --no-dereference "$work/one" "$work/other" || true
  # Modes and times.
  diff <(dpkg-deb --contents "$package") <(dpkg-deb --contents "$other") || true
done
exit "$code"
