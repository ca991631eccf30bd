#!/bin/busybox sh
# SPDX-License-Identifier: MIT
# shellcheck shell=dash
# First process of the guest: mounts the host's files as its root, below an overlay in memory for writes.
/bin/busybox --install -s /bin
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs dev /dev
for module in /modules/*; do insmod "$module"; done

# Shared folders: tag, place, options.
share() { mount -t 9p -o "trans=virtio,version=9p2000.L,msize=524288,$3" "$1" "$2" || poweroff -f; }
share host /host ro,cache=loose
mount -t tmpfs -o mode=755 memory /memory
mkdir /memory/written /memory/work
mount -t overlay -o lowerdir=/host,upperdir=/memory/written,workdir=/memory/work guest /guest || poweroff -f
mount -t tmpfs -o mode=755 run /guest/run
mkdir -p /guest/run/vm /guest/run/lock /dev/pts /dev/shm
share talk /guest/run/vm rw
read -r writable </guest/run/vm/writable
if [ -n "$writable" ]; then
  mkdir -p "/guest$writable"
  share writable "/guest$writable" rw,cache=mmap
fi
mount -t devpts devpts /dev/pts
mount -t tmpfs -o mode=1777 shm /dev/shm
ln -s /proc/self/fd /dev/fd
ifconfig lo 127.0.0.1 up
for place in proc sys dev; do mount --move "/$place" "/guest/$place"; done
# guest-vm.service starts main.
if [ -e /guest/run/vm/guest-vm.target ]; then
  mkdir -p /guest/run/systemd/system
  for unit in service target; do cp /guest/run/vm/guest-vm.$unit /guest/run/systemd/system/vm.$unit; done
  # With this file systemd would assume a container, which has no kernel command line.
  rm -f /guest/.dockerenv
  # Masks the unit that empties /tmp, which is the host's, and timers, which run later.
  for unit in systemd-tmpfiles-setup.service timers.target; do ln -s /dev/null "/guest/run/systemd/system/$unit"; done
  exec switch_root /guest /lib/systemd/systemd
fi
exec switch_root /guest /bin/bash /run/vm/main
