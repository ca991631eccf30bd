#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh OUT [BEFORE]: tests the packages of the folder OUT (make deb) as on a user's machine. lintian, AppStream; then in a fresh
# Debian, created once in build/debian.tar from this machine's package sources: install, pulse, upgrade, purge (inside.sh). The
# upgrade starts from the packages of the folder BEFORE; without it from those of OUT, with a lower version. The
# output is also written to OUT/transcript.txt.
# Packages for arm64 (make deb-arm64): in a fresh Debian for arm64, build/debian-arm64.tar, all of whose programs run in
# build/qemu-aarch64-static; their results are compared with those of this machine's programs in build/run (same_figures.py).
# Exit: 0 passed, 69 a fresh Debian cannot be created here.
set -euo pipefail

[ $# -eq 1 ] || [ $# -eq 2 ] || { echo "run.sh OUT [BEFORE]" >&2; exit 64; }
out=$(cd "$1" && pwd)
before=${2:+$(cd "$2" && pwd)}
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
build=$here/../../build
step() { echo; echo "tests/deb: $*"; }

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
work=$(mktemp -d)
trap '"${as_root[@]}" rm -rf "$work"' EXIT
root=$work/root
architecture=$(dpkg-deb --field "$out"/hedgehogd_*.deb Architecture)
base=$build/debian.tar
emulated=("${as_root[@]}")
options=()
if [ "$architecture" != "$(dpkg --print-architecture)" ]; then
  base=$build/debian-$architecture.tar
  emulated=("$here/emulated.sh" "$build/qemu-aarch64-static")
  # The namespace of the emulator has no sysfs of its own.
  options=(--mode=root --architectures="$architecture" "--skip=check/qemu,chroot/mount/sys")
fi

check_packages() {
  for package in "$out"/*.deb; do echo "$(($(stat -c %s "$package") / 1000)) kB  ${package##*/}"; done
  step "$(lintian --version)"
  # The project has no mail address yet.
  lintian --fail-on error,warning --show-overrides --allow-root \
    --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog "$out"/*.changes
  echo "no errors, no warnings"
  step "AppStream"
  appstreamcli validate --no-net "$here/../../systemd/hedgehogd.metainfo.xml"
}

try_packages() {
  if [ ! -s "$base" ]; then
    step "a fresh Debian"
    "${emulated[@]}" "$build/../cmake/fresh_debian.sh" "$base" --include=systemd,udev "${options[@]}"
  fi
  mkdir -p "$root"
  "${as_root[@]}" tar --extract --file "$base" --directory "$root"
  mkdir "$root/packages" "$root/packages/before"
  cp "$out"/*.deb "$here/inside.sh" "$here/snapshot.sh" "$here/trip.py" "$here/../install/links.sh" "$root/packages"
  [ "$base" = "$build/debian.tar" ] || cp "$here/figures.sh" "$root/packages"
  "$here/older.sh" "$root/packages/before" "$before" "$out"/*.deb
  step "a fresh Debian, $architecture"
  # shellcheck disable=SC2016  # expanded by the inner shell
  # In a separate namespace, with which its mounts and processes end.
  "${emulated[@]}" unshare --mount --pid --ipc --uts --fork --kill-child bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    mount -t tmpfs tmpfs "$1/run"
    [ ! -e /etc/resolv.conf ] || cp -L /etc/resolv.conf "$1/etc/resolv.conf"
    exec chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
      HEDGEHOG_PATIENCE_MS=60000 bash /packages/inside.sh' unshare "$root"
  if [ -e "$root/packages/figures.json" ]; then
    step "what it computes, beside this machine's"
    "$here/same_figures.py" "$build/run" "$root/packages/settings.json" "$root/packages/figures.json"
  fi
  step "all is well"
}

{
  check_packages
  try_packages
} 2>&1 | tee "$out/transcript.txt"
