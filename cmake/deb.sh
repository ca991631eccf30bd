#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# deb.sh BUILD OUT [ARCHITECTURE COMMAND...]: makes Debian packages of a finished build (with its pages in BUILD/share/hedgehog)
# in the folder OUT. The version is that of debian/changelog when a tag of that name is checked out, else that and the commit:
# +git<count>.<commit>. The same commit and compiler give the same bytes. COMMAND runs dpkg-buildpackage for another
# ARCHITECTURE where its cross compiler is installed (in_root.sh). Exit: 0, else dpkg-buildpackage's.
set -euo pipefail

[ $# -eq 2 ] || [ $# -ge 4 ] || { echo "deb.sh BUILD OUT [ARCHITECTURE COMMAND...]" >&2; exit 64; }
build=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
cd "$(dirname -- "${BASH_SOURCE[0]}")/.."

# dpkg-buildpackage writes into the folder of debian/ and above it.
rm -rf "${out:?}"/*
source=$out/source
mkdir "$source"
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  git ls-files -z | tar --null --files-from=- --create | tar --extract --directory "$source"
  version=$(dpkg-parsechangelog --show-field Version)
  if [ -z "$(git tag --points-at HEAD --list "v$version")" ]; then
    {
      printf 'hedgehog (%s+git%s.%s) unstable; urgency=medium\n\n  * Snapshot.\n\n' "$version" \
        "$(git rev-list --count HEAD)" "$(git rev-parse --short=7 HEAD)"
      printf ' -- %s  %s\n\n' "$(dpkg-parsechangelog --show-field Maintainer)" "$(git log -1 --format=%cD)"
      cat debian/changelog
    } >"$source/debian/changelog"
  fi
else
  tar --exclude=./build --create . | tar --extract --directory "$source"
fi

cd "$source"
"${@:4}" env HEDGEHOG_BUILD="$build" DEB_BUILD_OPTIONS="noautodbgsym ${DEB_BUILD_OPTIONS-}" dpkg-buildpackage --build=binary \
  ${3:+--host-arch="$3"} --unsigned-changes --unsigned-buildinfo --no-check-builddeps >"$out/build.log" 2>&1 || { code=$?; tail -40 "$out/build.log"; exit "$code"; }
cd "$out"
rm -rf "$source"
for package in *.deb; do printf '%8d kB  %s\n' "$(($(stat -c %s "$package") / 1000))" "$package"; done
