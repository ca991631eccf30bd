#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# deb_arm64.sh ROOT.tar PAGES OUT: makes Debian packages for arm64 in the folder OUT of this checkout, cross-compiled in the root
# of arm64_root.sh, into build/arm64; with the pages of the folder PAGES. JOBS: compilers at a time.
# Exit: 0, 64 usage, else cmake's or dpkg-buildpackage's.
set -euo pipefail

[ $# -eq 3 ] || { echo "deb_arm64.sh ROOT.tar PAGES OUT" >&2; exit 64; }
cd "$(dirname -- "${BASH_SOURCE[0]}")/.."
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
root=$(mktemp -d)
trap '"${as_root[@]}" rm -rf "$root"' EXIT
"${as_root[@]}" tar --extract --file "$1" --directory "$root"

mkdir -p build/arm64/share
cmake/in_root.sh "$root" cmake --preset arm64 >build/arm64/configure.log || { cat build/arm64/configure.log; exit 1; }
cmake/in_root.sh "$root" cmake --build --preset arm64 --parallel "${JOBS:-$(nproc)}"
rm -rf build/arm64/share/hedgehog
cp -rT "$2" build/arm64/share/hedgehog
cmake/deb.sh build/arm64 "$3" arm64 "$PWD/cmake/in_root.sh" "$root"
