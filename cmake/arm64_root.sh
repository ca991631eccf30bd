#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# arm64_root.sh QEMU OUT.tar: makes a fresh Debian with the cross compiler of apt/deb_arm64.txt, the Build-Depends of
# debian/control for arm64, and the emulator QEMU. Adds no foreign architecture to this machine. Exit: fresh_debian.sh's.
set -euo pipefail

[ $# -eq 2 ] || { echo "arm64_root.sh QEMU OUT.tar" >&2; exit 64; }
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
[ "$(dpkg --print-architecture)" != arm64 ] || { echo "arm64_root.sh: this machine is arm64: make deb" >&2; exit 64; }
qemu=$(realpath "$1")
packages=$(sed '/^#/d' "$here/apt/deb_arm64.txt" | paste -sd,)

# shellcheck disable=SC2016  # expanded by mmdebstrap's shell
"$here/fresh_debian.sh" "$2" --architectures="$(dpkg --print-architecture),arm64" --include="$packages" \
  --customize-hook='mkdir -p "$1/tmp/source/debian"' \
  --customize-hook="copy-in '$here/../debian/control' '$here/../debian/changelog' /tmp/source/debian" \
  --customize-hook='chroot "$1" env DEBIAN_FRONTEND=noninteractive apt-get -qq update' \
  --customize-hook='chroot "$1" sh -c "cd /tmp/source && exec env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq build-dep --yes --no-install-recommends --host-architecture arm64 ./"' \
  --customize-hook='rm -r "$1/tmp/source"' --customize-hook="upload '$qemu' /usr/bin/qemu-aarch64-static" \
  --customize-hook='chmod 755 "$1/usr/bin/qemu-aarch64-static"'
