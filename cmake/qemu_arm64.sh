#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# qemu_arm64.sh OUT: extracts Debian's qemu-aarch64-static from its package. The package itself, which registers its emulators
# with the kernel, is not installed. Exit: 0, 64 usage, 69 apt does not have it.
set -euo pipefail

[ $# -eq 1 ] || { echo "qemu_arm64.sh OUT" >&2; exit 64; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && apt-get -qq -o Acquire::Retries=3 -o APT::Sandbox::User="$(id -un)" download qemu-user-static >&2) ||
  { echo "qemu_arm64.sh: apt-get download qemu-user-static failed; apt-get update?" >&2; exit 69; }
dpkg-deb --fsys-tarfile "$work"/*.deb | tar -xm -C "$work" ./usr/bin/qemu-aarch64-static
mv "$work/usr/bin/qemu-aarch64-static" "$1"
