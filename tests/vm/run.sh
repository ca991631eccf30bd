#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a command where Linux has real USB, HID and udev: as root of an emulated machine with Debian's kernel and this
# machine's files, in the same folder and environment. Its writes stay in the guest, except those below DIR.
#   run.sh [-t SECONDS] [-w DIR] [-s] [-v] COMMAND [ARGUMENT...]
#     -t   limit in seconds of processor time (default 300); by the clock, five times as many
#     -w   the guest may write here
#     -s   systemd is the guest's first process, which starts basic.target and then the command
#     -v   the guest's kernel log at the end; also whenever the guest fails
# Exit: the command's; 64 usage, 69 something is missing, 70 the guest ended without a result, 124 timeout.
# HEDGEHOG_VM_QEMU: more options for qemu. README.md explains how it works.
set -euo pipefail

log_error() { echo "run.sh: $*" >&2; }

limit=300 writable='' verbose=0 systemd=''
while getopts t:w:sv option; do
  case $option in
    t)
      limit=$OPTARG
      [[ $limit =~ ^[1-9][0-9]*$ ]] || { log_error "-t $limit: must be a number of seconds, 1 or more"; exit 64; }
      ;;
    w) writable=$(realpath "$OPTARG") ;;
    s) systemd="systemd.unit=vm.target fstab=no systemd.show_status=no" ;;
    v) verbose=1 ;;
    *) exit 64 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || { log_error "no command"; exit 64; }

here=$(realpath "$(dirname -- "${BASH_SOURCE[0]}")")
PATH=$PATH:/usr/sbin:/sbin
for tool in qemu-system-x86_64 busybox cpio modprobe depmod xz; do
  command -v "$tool" >/dev/null || { log_error "there is no $tool (cmake/bootstrap.sh vm)"; exit 69; }
done
kernel=$("$here/kernel.sh") || exit 69
version=$(ls "$kernel/lib/modules")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
talk=$work/talk
mkdir -p "$talk" "$work/image"/{bin,modules,proc,sys,dev,host,memory,guest}

# The initial file system of the guest: busybox, the modules needed to mount this machine's files, guest-init.
busybox=$(command -v busybox)
cp "$busybox" "$work/image/bin/busybox"
cp "$busybox" "$talk/busybox"
cp "$here/guest-init.sh" "$work/image/init"
chmod 755 "$work/image/init"
number=100
for module in $(for name in virtio_pci 9pnet_virtio 9p overlay; do
  modprobe -d "$kernel" -S "$version" --show-depends "$name"
done | sed -n 's/^insmod \([^ ]*\).*/\1/p' | awk '!seen[$0]++'); do
  cp "$module" "$work/image/modules/$number-${module##*/}"
  number=$((number + 1))
done
(cd "$work/image" && find . | cpio -o -H newc --quiet >"$work/initrd")

# The guest's command, in a folder shared by both sides.
{
  export -p
  printf 'cd %q || exit 70\n' "$PWD"
  printf '%q ' "$@"
  echo
} >"$talk/command"
printf '%s\n' "$kernel" >"$talk/kernel"
printf '%s\n' "$writable" >"$talk/writable"
cp "$here/guest-main.sh" "$talk/main"
[ -z "$systemd" ] || cp "$here/guest-vm.service" "$here/guest-vm.target" "$talk"

# One emulated processor whose clock counts its own instructions, 1 ns each: time in the guest is independent of this
# machine's load. A basic one: vector instructions, which libc would use, take longer to emulate than the scalar ones.
# shellcheck disable=SC2054 # the commas are qemu's
machine=(qemu-system-x86_64 -nodefaults -no-user-config -display none -monitor none -no-reboot
  -machine pc -accel "tcg,thread=single" -icount shift=0,sleep=off -cpu qemu64 -smp 1 -m 768
  -kernel "$kernel/vmlinux" -initrd "$work/initrd"
  -append "console=ttyS0 quiet panic=-1 tsc=reliable mitigations=off nohz=off random.trust_cpu=on $systemd"
  -serial "file:$work/console" -serial stdio
  -object "rng-random,id=random,filename=/dev/urandom" -device "virtio-rng-pci,rng=random")
folder() { # tag, path, more
  machine+=(-fsdev "local,id=$1,path=$2,security_model=none,multidevs=remap$3" -device "virtio-9p-pci,fsdev=$1,mount_tag=$1")
}
folder host / ,readonly=on
folder talk "$talk" ""
[ -z "$writable" ] || folder writable "$writable" ""
read -ra more <<<"${HEDGEHOG_VM_QEMU:-}"

# Processor time, which is independent of this machine's load; a guest that only waits takes some, too. The limit by the clock is for
# one that is stuck in a call of this machine's kernel.
status=0
by_clock=$((5 * limit))
(
  ulimit -S -c 0 && ulimit -S -t "$limit" || exit 69
  exec timeout --foreground -k 5 "$by_clock" "${machine[@]}" "${more[@]}" </dev/null
) || status=$?
if [ -s "$talk/exit" ]; then
  result=$(<"$talk/exit")
elif [ "$status" = 152 ]; then # SIGXCPU
  log_error "out of time after $limit s of processor time"
  result=124 verbose=1
elif [ "$status" = 124 ] || [ "$status" = 137 ]; then
  log_error "out of time after $by_clock s"
  result=124 verbose=1
else
  log_error "the guest ended without a result (qemu: $status); its console:"
  result=70 verbose=1
fi
[ "$verbose" = 0 ] || tail -n 200 "$work/console" >&2 || true
exit "$result"
