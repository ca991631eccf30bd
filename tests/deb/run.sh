#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh OUT [BEFORE]: the packages of the folder OUT (make deb) as a stranger's machine takes them. lintian, AppStream; then in a
# fresh Debian, made once in build/debian.tar from this machine's own sources of packages: install, pulse, upgrade, purge
# (inside.sh). The upgrade comes from the packages of the folder BEFORE; without it from these, with a lower version and another
# text of the settings. What it prints is also written to OUT/transcript.txt.
# Packages for arm64 (make deb-arm64): in a fresh Debian for arm64, build/debian-arm64.tar, all of whose programs run in
# build/qemu-aarch64-static; what they compute is compared with this machine's programs (same_figures.py), those of build/run.
# Exit: 0 all is well, 69 a fresh Debian cannot be made here.
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

# What an upgrade comes from: the same with a lower version and other settings, or what is given.
lay_packages_before() {
  local package name old new settings=$work/unpacked/etc/hedgehog/hedgehogd.json
  mkdir "$root/packages/before"
  if [ -n "$before" ]; then
    cp "$before"/*.deb "$root/packages/before"
    for package in "$root"/packages/before/*.deb; do
      name=$(dpkg-deb --field "$package" Package)
      old=$(dpkg-deb --field "$package" Version)
      new=$(dpkg-deb --field "$out/$name"_*.deb Version)
      dpkg --compare-versions "$old" lt "$new" || { echo "tests/deb: $name $old is not older than $new" >&2; exit 1; }
    done
    return
  fi
  for package in "$out"/*.deb; do
    rm -rf "$work/unpacked"
    dpkg-deb --raw-extract "$package" "$work/unpacked"
    sed -i -E 's/^Version: .*/Version: 0.0.1/; s/(hedgehog[a-z]* \(= )[^)]*/\10.0.1/' "$work/unpacked/DEBIAN/control"
    [ ! -e "$settings" ] || echo "// Of version 0.0.1." >>"$settings"
    dpkg-deb --root-owner-group --build "$work/unpacked" "$root/packages/before" >/dev/null
  done
}

try_packages() {
  if [ ! -s "$base" ]; then
    step "a fresh Debian"
    "${emulated[@]}" "$build/../cmake/fresh_debian.sh" "$base" --include=systemd,udev "${options[@]}"
  fi
  mkdir -p "$root"
  "${as_root[@]}" tar --extract --file "$base" --directory "$root"
  mkdir "$root/packages"
  cp "$out"/*.deb "$here/inside.sh" "$here/snapshot.sh" "$here/trip.py" "$here/../install/links.sh" "$root/packages"
  [ "$base" = "$build/debian.tar" ] || cp "$here/figures.sh" "$root/packages"
  lay_packages_before
  step "a fresh Debian, $architecture"
  # shellcheck disable=SC2016  # expanded by the inner shell
  # A namespace of its own: what is mounted and started in it ends with it.
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
