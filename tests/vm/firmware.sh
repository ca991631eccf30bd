#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# As run.sh, in a guest whose third serial port is connected to the emulated board on this machine (emulator/firmware/README.md):
# there `hedgehog-usbip --vhci firmware-board` is the USB device of the firmware's image.
#   firmware.sh [run.sh's options] COMMAND [ARGUMENT...]
# HEDGEHOG_FIRMWARE_ELF, HEDGEHOG_FIRMWARE_PLANT: image and program of the ball; HEDGEHOG_FIRMWARE_PACKAGES: folder of npm's
# packages. Without them, those that `make test-usb` builds.
# Exit: run.sh's, or 69: the emulated board does not start.
set -euo pipefail

here=$(realpath "$(dirname -- "${BASH_SOURCE[0]}")")
top=$(realpath "$here/../..")
work=$(mktemp -d)
socket=$work/board
# The script replaces itself by node: this is the process that `end` ends.
"$top/tests/firmware/emulated/run.sh" "${HEDGEHOG_FIRMWARE_ELF:-$top/build/firmware/usb/hedgehog-board.elf}" \
  "${HEDGEHOG_FIRMWARE_PLANT:-$top/build/dev/tests/firmware/firmware_plant}" \
  "${HEDGEHOG_FIRMWARE_PACKAGES:-$top/build/npm/firmware}" "$top/build" usbip "$socket" &
board=$!
end() {
  kill "$board" 2>/dev/null || true
  wait "$board" || true
  rm -rf "$work"
}
trap end EXIT
until [ -S "$socket" ]; do
  kill -0 "$board" 2>/dev/null || { echo "firmware.sh: the emulated board does not start" >&2; exit 69; }
  sleep 0.1
done

# Its interrupt is not that of the console's port, and is not used.
HEDGEHOG_VM_QEMU="${HEDGEHOG_VM_QEMU:-} -chardev socket,id=board,path=$socket -device isa-serial,chardev=board,iobase=0x3e8,irq=5" \
  "$here/run.sh" "$@"
