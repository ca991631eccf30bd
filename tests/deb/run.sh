#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh OUT: the packages of the folder OUT (make deb) as a stranger's machine takes them. lintian; then in a fresh Debian,
# made once in build/debian.tar from this machine's own sources of packages: install, pulse, upgrade, purge (inside.sh).
# Exit: 0 all is well, 69 a fresh Debian cannot be made here.
set -euo pipefail

[ $# -eq 1 ] || { echo "run.sh OUT" >&2; exit 64; }
out=$(cd "$1" && pwd)
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
base=$here/../../build/debian.tar
step() { echo "tests/deb: $*"; }

step "lintian"
# The project has no mail address yet.
lintian --fail-on error,warning --allow-root --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog "$out"/*.changes

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
work=$(mktemp -d)
trap '"${as_root[@]}" rm -rf "$work"' EXIT

# Settings of apt, a proxy for example, belong to the sources.
settings=()
for file in /etc/apt/apt.conf.d/*; do
  ! grep -qi '^ *acquire' "$file" || settings+=("--aptopt=$file")
done
if [ ! -s "$base" ]; then
  step "a fresh Debian"
  # shellcheck disable=SC1091
  . /etc/os-release
  sources=()
  for file in /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list /etc/apt/sources.list; do
    [ ! -s "$file" ] || sources+=("$file")
  done
  "${as_root[@]}" mmdebstrap --quiet --variant=apt --include=systemd,udev "${settings[@]}" "$VERSION_CODENAME" \
    "$work/base.tar" "${sources[@]}" || exit 69
  mv "$work/base.tar" "$base"
fi

root=$work/root
mkdir -p "$root"
"${as_root[@]}" tar --extract --file "$base" --directory "$root"
mkdir "$root/packages" "$root/packages/before"
cp "$out"/*.deb "$here/inside.sh" "$root/packages"

# What an upgrade comes from: the same with a lower version.
for package in "$out"/*.deb; do
  rm -rf "$work/unpacked"
  dpkg-deb --raw-extract "$package" "$work/unpacked"
  sed -i -E 's/^Version: .*/Version: 0.0.1/; s/(hedgehog[a-z]* \(= )[^)]*/\10.0.1/' "$work/unpacked/DEBIAN/control"
  dpkg-deb --root-owner-group --build "$work/unpacked" "$root/packages/before" >/dev/null
done

step "install, pulse, upgrade, purge"
# shellcheck disable=SC2016  # expanded by the inner shell
# A namespace of its own: what is mounted and started in it ends with it.
"${as_root[@]}" unshare --mount --pid --ipc --uts --fork --kill-child bash -euc '
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  mount -t tmpfs tmpfs "$1/run"
  [ ! -e /etc/resolv.conf ] || cp -L /etc/resolv.conf "$1/etc/resolv.conf"
  exec chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    HEDGEHOG_PATIENCE_MS=60000 bash /packages/inside.sh' unshare "$root"
step "all is well"
