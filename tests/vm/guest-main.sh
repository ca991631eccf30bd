# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Runs in the guest on the host's files: modules, udev, the command, power-off. Never sourced; guest-init starts it as
# process 1, with run.sh -s systemd as vm.service.
exec </dev/null >/dev/ttyS0 2>&1
mkdir -p /lib/modules
mount --bind "$(</run/vm/kernel)/lib/modules" /lib/modules
modprobe -a vhci-hcd usbhid hid-generic uinput evdev joydev
[ -d /run/systemd/system ] || /lib/systemd/systemd-udevd --daemon
udevadm trigger --action=add --subsystem-match=usb --subsystem-match=hid --subsystem-match=hidraw
udevadm settle

# The second serial line carries the command's output unchanged.
stty -F /dev/ttyS1 raw -echo
setsid bash /run/vm/command </dev/null >/dev/ttyS1 2>&1
echo $? >/run/vm/exit
stty -F /dev/ttyS1 raw # returns when all output has been sent
sync
/run/vm/busybox poweroff -f
