#!/bin/sh
# SPDX-License-Identifier: MIT
# Fetches Debian's kernel and keeps the files that the guest needs. kernel.sh prints the folder, which then holds
#   vmlinux          the kernel that qemu boots
#   lib/modules/...  usb, hid, input, iio, virtio, 9p, overlayfs
# The package is unpacked, never installed; HEDGEHOG_VM_CACHE (default ~/.cache/hedgehog-vm) keeps it.
# Exit: 0, 69 it is not available.
set -eu

cache=${HEDGEHOG_VM_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/hedgehog-vm}

give_up() { echo "kernel.sh: $*" >&2; exit 69; }

newest_package() {
  # The standard kernel: the one for clouds has neither USB nor 9p.
  LC_ALL=C apt-cache depends linux-image-amd64 2>/dev/null |
    sed -n 's/^ *Depends: \(linux-image-[^ ]*-amd64\)$/\1/p' | head -n 1
}

fetch() { # folder
  package=$(newest_package)
  if [ -z "$package" ]; then
    apt-get update >&2 || true
    package=$(newest_package)
  fi
  [ -n "$package" ] || give_up "apt knows no linux-image-amd64"
  (cd "$1" && apt-get -qq -o Acquire::Retries=3 -o APT::Sandbox::User="$(id -un)" download "$package" >&2) ||
    give_up "apt-get download $package failed"
}

unpack() { # folder
  modules='./lib/modules/*/kernel'
  dpkg-deb --fsys-tarfile "$1"/*.deb | tar -x -C "$1" --wildcards './boot/vmlinuz-*' './lib/modules/*/modules.*' \
    "$modules/drivers/usb/*" "$modules/drivers/hid/*" "$modules/drivers/input/*" "$modules/drivers/iio/*" \
    "$modules/drivers/virtio/*" "$modules/drivers/char/*" "$modules/drivers/leds/*" "$modules/drivers/power/*" \
    "$modules/lib/*" "$modules/net/9p/*" "$modules/fs/9p/*" "$modules/fs/netfs/*" "$modules/fs/fscache/*" \
    "$modules/fs/overlayfs/*" || true # a folder that this kernel does not have
  rm "$1"/*.deb
  set -- "$1" "$1"/boot/vmlinuz-*
  [ -s "$2" ] || give_up "the package has no kernel"
  PATH=$PATH:/sbin:/usr/sbin depmod -b "$1" "$(ls "$1/lib/modules")"
  # Unpacked once here, which shortens a start by two seconds. The xz data is found in the kernel by its magic number.
  at=$(LC_ALL=C grep -abo "$(printf '\375')7zXZ" "$2" | head -n 1 | cut -d: -f1)
  [ -z "$at" ] || tail -c "+$((at + 1))" "$2" | xz -dc >"$1/vmlinux" 2>/dev/null || true # other data follows it
  [ "$(head -c 4 "$1/vmlinux" 2>/dev/null | tail -c 3)" = ELF ] || cp "$2" "$1/vmlinux"
  rm -r "${1:?}/boot"
}

if [ ! -s "$cache/ready/vmlinux" ]; then
  mkdir -p "$cache"
  made=$(mktemp -d "$cache/fetch.XXXXXX")
  trap 'rm -rf "$made"' EXIT
  fetch "$made"
  unpack "$made"
  chmod 755 "$made"
  # Another process may have been first; its result is equivalent.
  mv -T "$made" "$cache/ready" 2>/dev/null || [ -s "$cache/ready/vmlinux" ] || give_up "cannot write $cache"
fi
echo "$cache/ready"
