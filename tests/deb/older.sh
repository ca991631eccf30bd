#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# older.sh FOLDER BEFORE PACKAGE...: writes to FOLDER the packages from which an upgrade to the PACKAGEs (files) starts: those of
# the same names in the folder BEFORE, all of which must be older; with an empty BEFORE the PACKAGEs themselves as version 0.0.1, with
# another text of the settings.
# Exit: 0, 1 a package of BEFORE is not older or it has none of them, 64 usage.
set -euo pipefail

[ $# -ge 3 ] || { echo "older.sh FOLDER BEFORE PACKAGE..." >&2; exit 64; }
folder=$1 before=$2
shift 2
work=$(mktemp -d)
settings=$work/unpacked/etc/hedgehog/hedgehogd.json
trap 'rm -rf "$work"' EXIT

# relabel PACKAGE: the same contents but for a comment in the settings; packages of this project that depend on this version depend on 0.0.1.
relabel() {
  dpkg-deb --raw-extract "$1" "$work/unpacked"
  sed -i -E 's/^Version: .*/Version: 0.0.1/; s/(hedgehog[a-z]* \(= )[^)]*/\10.0.1/' "$work/unpacked/DEBIAN/control"
  [ ! -e "$settings" ] || echo "// Of version 0.0.1." >>"$settings"
  dpkg-deb --root-owner-group --build "$work/unpacked" "$folder" >/dev/null
  rm -rf "$work/unpacked"
}

for package; do
  if [ -z "$before" ]; then
    relabel "$package"
    continue
  fi
  name=$(dpkg-deb --field "$package" Package)
  for older in "$before/$name"_*.deb; do
    # A package that the other commit does not have yet is new in the upgrade.
    [ -e "$older" ] || continue
    old=$(dpkg-deb --field "$older" Version)
    new=$(dpkg-deb --field "$package" Version)
    dpkg --compare-versions "$old" lt "$new" || { echo "older.sh: $name $old is not older than $new" >&2; exit 1; }
    cp "$older" "$folder"
  done
done
compgen -G "$folder/*.deb" >/dev/null || { echo "older.sh: $before has none of these packages" >&2; exit 1; }
