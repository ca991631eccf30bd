#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# in_root.sh ROOT COMMAND...: runs the command in the unpacked root ROOT, as this user, with this checkout at the same path and
# in the same current folder. Its mounts and processes end with it. Exit: the command's.
set -euo pipefail

[ $# -ge 2 ] || { echo "in_root.sh ROOT COMMAND..." >&2; exit 64; }
checkout=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo -n)

# shellcheck disable=SC2016  # expanded by the inner shells
exec "${as_root[@]}" unshare --mount --pid --ipc --fork --kill-child bash -euc '
  root=$1 checkout=$2 folder=$3 user=$4
  shift 4
  mkdir -p "$root$checkout"
  mount --bind "$checkout" "$root$checkout"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  exec chroot --userspec="$user" "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/tmp LC_ALL=C.UTF-8 \
    bash -euc "cd -- \"\$1\"; shift; exec \"\$@\"" bash "$folder" "$@"' \
  bash "$(cd "$1" && pwd)" "$checkout" "$PWD" "$(id -u):$(id -g)" "${@:2}"
