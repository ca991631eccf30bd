#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# fresh_debian.sh OUT.tar [OPTION...]: makes the root of a fresh Debian of this machine's release, from this machine's package
# sources. OPTIONs are mmdebstrap's. Needs root, or sudo without password. Exit: 0, 64 usage, 69 it cannot be made here.
set -euo pipefail

[ $# -ge 1 ] || { echo "fresh_debian.sh OUT.tar [OPTION...]" >&2; exit 64; }
out=$1
shift
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
work=$(mktemp -d)
trap '"${as_root[@]}" rm -rf "$work"' EXIT

# The package sources may need settings of apt, for example a proxy.
settings=()
for file in /etc/apt/apt.conf.d/*; do
  ! grep -qi '^ *acquire' "$file" || settings+=("--aptopt=$file")
done
sources=()
for file in /etc/apt/sources.list.d/*.sources /etc/apt/sources.list.d/*.list /etc/apt/sources.list; do
  [ ! -s "$file" ] || sources+=("$file")
done
# shellcheck disable=SC1091
. /etc/os-release
# /usr is merged from the start, which saves hundreds of processes that would merge it later.
"${as_root[@]}" mmdebstrap --quiet --variant=apt --hook-dir=/usr/share/mmdebstrap/hooks/merged-usr "${settings[@]}" "$@" "$VERSION_CODENAME" \
  "$work/root.tar" "${sources[@]}" || exit 69
mv "$work/root.tar" "$out"
