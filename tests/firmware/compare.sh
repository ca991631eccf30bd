#!/bin/sh
# SPDX-License-Identifier: MIT
# The vectors on the host and, with the board core of the image, on a Cortex-M0 under qemu: their output must be equal.
# compare.sh HOST_PROGRAM ELF. Exit: 0 the same and as expected, 1 different, 64 usage, 69 no qemu.
set -eu

[ $# -eq 2 ] || { echo "compare.sh HOST_PROGRAM ELF" >&2; exit 64; }
command -v qemu-system-arm >/dev/null || { echo "compare.sh: no qemu-system-arm" >&2; exit 69; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$1" >"$work/host"
timeout 600 qemu-system-arm -M microbit -nographic -monitor none -serial none \
  -semihosting-config enable=on,target=native -kernel "$2" >"$work/cortex" 2>"$work/said" </dev/null
cat "$work/said"
diff "$work/host" "$work/cortex"
printf '%d frames of telemetry, the same on both\n' "0x$(sed -n 's/^frames: //p' "$work/host")"
