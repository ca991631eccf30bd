#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# emulated.sh QEMU COMMAND...: runs the command as root, with programs for arm64 in QEMU (a static qemu-aarch64-static). From
# Linux 6.7 on this is done in a user namespace with its own list of binary formats, so that the machine's list is unchanged; with
# an older kernel, only if the machine's list contains arm64. Exit: the command's, 69 neither is available.
set -euo pipefail

[ $# -ge 2 ] || { echo "emulated.sh QEMU COMMAND..." >&2; exit 64; }
[ "$(id -u)" -eq 0 ] || exec sudo -n "$0" "$@"
qemu=$(realpath "$1")
shift
formats=/proc/sys/fs/binfmt_misc
[ "$(uname -m)" != aarch64 ] || exec "$@"
if ! unshare --user --map-root-user --mount mount -t binfmt_misc binfmt_misc "$formats" 2>/dev/null; then
  [ -e "$formats/qemu-aarch64" ] || {
    echo "emulated.sh: this kernel has no binary formats for a namespace of its own (Linux 6.7): install qemu-user-static" >&2
    exit 69
  }
  exec "$@"
fi

pipes=$(mktemp -d)
# unshare blocks SIGTERM; the processes in its namespace end with it.
trap '[ -z "${child-}" ] || kill -KILL "$child" 2>/dev/null || true; rm -rf "$pipes"' EXIT
mkfifo "$pipes/unshared" "$pipes/mapped"
# shellcheck disable=SC2016  # expanded by the inner shell
unshare --user --mount --pid --ipc --fork --kill-child bash -euc '
  pipes=$1 qemu=$2 formats=$3
  shift 3
  echo >"$pipes/unshared"
  read -r <"$pipes/mapped"
  mount -t proc proc /proc
  mount -t binfmt_misc binfmt_misc "$formats"
  # The header of an ELF program (64 bit, little-endian, executable or shared) for the machine 0xb7. F: opened here, for all roots.
  header="\x7f\x45\x4c\x46\x02\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\xb7\x00"
  mask="\xff\xff\xff\xff\xff\xff\xff\x00\xff\xff\xff\xff\xff\xff\xff\xff\xfe\xff\xff\xff"
  printf "%s" ":qemu-aarch64:M::$header:$mask:$qemu:F" >"$formats/register"
  exec "$@"' bash "$pipes" "$qemu" "$formats" "$@" &
child=$!
read -r <"$pipes/unshared"
# Maps every user and group to itself.
for map in uid_map gid_map; do echo "0 0 4294967295" >"/proc/$child/$map"; done
echo >"$pipes/mapped"
wait "$child"
