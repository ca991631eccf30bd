#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# service.sh PACKAGES EMULATOR [BEFORE]: hedgehogd and hedgehog-tools of the folder PACKAGES (make deb) under systemd, in a guest of
# run.sh -s: upgraded from an older version (of the folder BEFORE, or relabelled: tests/deb/older.sh) while all services run, killed,
# hung, reloaded, stopped; permissions, journal; several balls, also started by udev when their boards are plugged in (EMULATOR:
# hedgehog-usbip); purged while all services run. Exit: 0 passed. The functions of its steps: service_functions.sh.
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
if [ "${1-}" != --inside ]; then
  [ $# -eq 2 ] || [ $# -eq 3 ] || { echo "service.sh PACKAGES EMULATOR [BEFORE]" >&2; exit 64; }
  older=$(mktemp -d)
  trap 'rm -rf "$older"' EXIT
  "$here/../deb/older.sh" "$older" "${3-}" "$1"/hedgehogd_*.deb "$1"/hedgehog-tools_*.deb
  "$here/run.sh" -t "${VM_SECONDS:-1200}" -s "$here/service.sh" --inside "$(realpath "$1")" "$(realpath "$2")" "$older"
  exit
fi

packages=$2 usbip=$3 older=$4
export LC_ALL=C.UTF-8 HEDGEHOG_PATIENCE_MS=60000 DEBIAN_FRONTEND=noninteractive SYSTEMD_PAGER=cat
unset HEDGEHOG_ADDRESS RUNTIME_DIRECTORY XDG_RUNTIME_DIR
# shellcheck source=tests/vm/service_functions.sh
source "$here/service_functions.sh"

# The host's file; services may start in the guest.
rm -f /usr/sbin/policy-rc.d

step "install, of an older version, with a board plugged in: enabled, started, ready"
# Without a HID device the kernel's hid is not loaded, and the service must load it.
modprobe -r usbhid hid-generic hid
! grep -qw hidraw /proc/devices || fail "hid cannot be unloaded"
emulate board,serial=0006
board=
found_board() { board=$(grep -lx 0006 /sys/bus/usb/devices/*/serial); }
eventually found_board
board=${board%/serial}
board=/dev/bus/usb/$(printf '%03d/%03d' "$(<"$board/busnum")" "$(<"$board/devnum")")
install "$older"/*.deb
eventually is ActiveState active
[ "$(systemctl is-enabled hedgehogd)" = enabled ] || fail "it is not enabled"
for unit in hedgehog-gamepad hedgehog-mqtt; do
  [ "$(systemctl is-enabled "$unit")" = disabled ] || fail "$unit is enabled"
  are "$unit" ActiveState=inactive
done
are hedgehogd User=hedgehog
property StatusText | grep -q "^SIMULATOR: armed" || fail "its status is '$(property StatusText)'"
hedgehogctl pulse left

# What stops and restarts services are the preinst and the postinst of the new package. The older one's prerm and postrm do nothing in
# an upgrade, so the step is the same for all packages of BEFORE.
step "upgrade: the processes of the new version, with settings and state as before"
echo '{ "limits": { "current_a": 12 } }' >/etc/hedgehog/hedgehogd.json
echo '{ "listen": { "tcp": ["127.0.0.1:7596"] }, "http": { "listen": "127.0.0.1:7597" }, "limits": { "current_a": 11 } }' >/etc/hedgehog/0007.json
systemctl start hedgehogd@0007
ctl 0007 stop
clients=(hedgehog-gamepad hedgehog-mqtt)
# Packages of BEFORE may have no instances of hedgehog-mqtt yet.
[ ! -e /lib/systemd/system/hedgehog-mqtt@.service ] || clients+=(hedgehog-mqtt@0007)
systemctl start "${clients[@]}"
eventually has_gamepad
eventually logged "no broker at 127.0.0.1" hedgehog-mqtt
declare -A processes
for unit in hedgehogd hedgehogd@0007 "${clients[@]}"; do processes[$unit]=$(property MainPID "$unit"); done
install "$packages"/{hedgehogd,hedgehog-tools}_*.deb
[ "$(dpkg-query --show --showformat '${Version}' hedgehogd)" = "$(dpkg-deb --field "$packages"/hedgehogd_*.deb Version)" ] ||
  fail "the version is $(dpkg-query --show hedgehogd)"
for unit in "${!processes[@]}"; do renewed "$unit" "${processes[$unit]}"; done
eventually has_gamepad
for unit in hedgehogd hedgehogd@0007; do logged "coils off" "$unit" || fail "$unit did not stop orderly"; done
[ "$(systemctl is-enabled hedgehogd)" = enabled ] || fail "it is not enabled any more"
grep -qw hidraw /proc/devices || fail "the service cannot be allowed to use a HID device"
belongs_to_group() { [ "$(stat --format '%a %G' "$board")" = "660 hedgehog" ]; }
eventually belongs_to_group
end_emulator
for unit in hedgehog-gamepad hedgehog-mqtt; do
  [ "$(systemctl is-enabled "$unit")" = disabled ] || fail "$unit is enabled"
done
has . state '"armed"' || fail "the ball is not armed any more"
has . limit_a 12 || fail "hedgehogd has other settings"
has 0007 limit_a 11 || fail "hedgehogd@0007 has other settings"
has 0007 reason '"emergency_stop"' || fail "hedgehogd@0007 does not know of the emergency stop any more"
hedgehogctl pulse left
ctl 0007 arm
ctl 0007 pulse left
systemctl stop hedgehogd@0007 "${clients[@]}"

step "upgrade: services of the tools that are stopped stay so"
install "$packages"/hedgehog-tools_*.deb
for unit in "${clients[@]}"; do are "$unit" ActiveState=inactive Result=success; done

step "permissions of socket, state and settings"
modes=$(stat --format '%a %U:%G %n' /run/hedgehog /run/hedgehog/hedgehogd.sock /var/lib/hedgehog /etc/hedgehog/hedgehogd.json)
[ "$modes" = "755 hedgehog:hedgehog /run/hedgehog
660 hedgehog:hedgehog /run/hedgehog/hedgehogd.sock
750 hedgehog:hedgehog /var/lib/hedgehog
644 root:root /etc/hedgehog/hedgehogd.json" ] || fail "$modes"
! setpriv --reuid=nobody --regid=nogroup --clear-groups hedgehogctl --address /run/hedgehog/hedgehogd.sock status 2>/tmp/out ||
  fail "the socket lets nobody in"
grep -qi "permission denied" /tmp/out || fail "$(cat /tmp/out)"
setpriv --reuid=nobody --regid=nogroup --groups="$(getent group hedgehog | cut -d: -f3)" \
  hedgehogctl --address /run/hedgehog/hedgehogd.sock stop || fail "the socket does not let the group in"
hedgehogctl arm

step "killed: started again"
process=$(property MainPID)
kill -KILL "$process"
eventually restarted 1 "$process"
eventually hedgehogctl status
logged "Main process exited, code=killed" || fail "the journal does not have it"

step "hung: the watchdog's end, started again"
process=$(property MainPID)
kill -STOP "$process"
eventually logged "Watchdog timeout"
eventually restarted 2 "$process"
eventually hedgehogctl status

step "reloaded; wrong settings are refused and the old ones stay"
process=$(property MainPID)
echo '{ "limits": { "current_a": 10 } }' >/etc/hedgehog/hedgehogd.json
systemctl reload hedgehogd
eventually logged "configuration reloaded"
eventually has . limit_a 10
echo '{ "limits": { "curent_a": 9 } }' >/etc/hedgehog/hedgehogd.json
! systemctl reload hedgehogd 2>/tmp/out || fail "it reloads wrong settings"
eventually logged "did you mean"
are hedgehogd ActiveState=active "MainPID=$process"
has . limit_a 10 || fail "the refused settings have changed something"

step "for other machines: a socket unit, in which the service's own restriction to loopback stays"
ip address add 192.0.2.7/32 dev lo
HEDGEHOG_TOKEN=$(hedgehogctl token add arcade --role play | head -n 1)
HEDGEHOG_FINGERPRINT=$(hedgehogctl token certificate | head -n 1)
export HEDGEHOG_TOKEN HEDGEHOG_FINGERPRINT
echo '{ "listen": { "tcp": ["127.0.0.1:7586", "192.0.2.7:7586"] }, "http": { "listen": "192.0.2.7:7587" } }' >/etc/hedgehog/hedgehogd.json
systemctl restart hedgehogd
from_afar() { HEDGEHOG_PATIENCE_MS=$1 hedgehogctl --address tls://192.0.2.7:7586 "${@:2}"; }
! from_afar 3000 status >/tmp/out 2>&1 || fail "the service exchanges packets with other machines: $(cat /tmp/out)"
# The example of systemd/other-machines.md, with this machine's address.
sed -n 's/^    //p' /usr/share/doc/hedgehogd/other-machines.md | sed -n '/^Description=.*other machines/,/^WantedBy=/p' |
  sed -e '1i[Unit]' -e 's/192.168.7.5/192.0.2.7/; s/192.168.7.0/192.0.2.0/' >/etc/systemd/system/hedgehogd.socket
[ "$(grep -c "ListenStream=192.0.2.7:758[67]" /etc/systemd/system/hedgehogd.socket)" = 2 ] || fail "the documents have no socket unit"
systemctl daemon-reload
systemctl enable --quiet hedgehogd.socket
systemctl restart hedgehogd
are hedgehogd.socket ActiveState=active
eventually from_afar 60000 pulse left
scraped() {
  python3 -c '
import os, ssl, urllib.request
page = urllib.request.Request("https://192.0.2.7:7587/metrics", headers={"Authorization": "Bearer " + os.environ["HEDGEHOG_TOKEN"]})
assert b"hedgehog_build_info" in urllib.request.urlopen(page, timeout=60, context=ssl._create_unverified_context()).read()'
}
eventually scraped
# As it runs, with that socket and TLS.
systemd-analyze security --threshold=15 hedgehogd >/tmp/out || fail "its exposure is above 1.5: $(cat /tmp/out)"
tail -n 1 /tmp/out
# Avahi, which the restricted service asks by D-Bus, announces it while it runs.
ip link set lo multicast on
systemctl start avahi-daemon
announced() { avahi-browse --parsable --resolve --terminate _hedgehog._tcp | grep -q '^=;.*;7586;.*"tls=1"'; }
withdrawn() { avahi-browse --terminate --all >/dev/null && ! announced; }
eventually announced
# From an address that the socket does not allow.
ip address add 198.51.100.7/32 dev lo
! python3 -c 'import socket; socket.create_connection(("192.0.2.7", 7586), 3, ("198.51.100.7", 0))' 2>/tmp/out ||
  fail "an address is let in that is not allowed"
grep -q "timed out" /tmp/out || fail "$(cat /tmp/out)"
process=$(property MainPID)
kill -KILL "$process"
eventually from_afar 60000 status
[ "$(property MainPID)" != "$process" ] || fail "it was not started again"
systemctl stop hedgehogd
eventually withdrawn
systemctl stop avahi-daemon.socket avahi-daemon
eventually is ActiveState inactive hedgehogd.socket
! from_afar 3000 status >/tmp/out 2>&1 || fail "a client has started the stopped service"
are hedgehogd ActiveState=inactive
systemctl start hedgehogd
eventually from_afar 60000 status
echo '{ "nonsense": 1 }' >/etc/hedgehog/hedgehogd.json
systemctl restart hedgehogd 2>/dev/null && fail "it starts with nonsense"
eventually is ActiveState inactive hedgehogd.socket
! from_afar 3000 status >/tmp/out 2>&1 || fail "a client has started the failed service"
are hedgehogd ActiveState=failed ExecMainStatus=78 NRestarts=0
systemctl reset-failed hedgehogd
systemctl disable --quiet hedgehogd.socket
rm /etc/systemd/system/hedgehogd.socket
systemctl daemon-reload
unset HEDGEHOG_TOKEN HEDGEHOG_FINGERPRINT
rm /var/lib/hedgehog/tokens
echo '{}' >/etc/hedgehog/hedgehogd.json
systemctl start hedgehogd

step "stopped: orderly"
echo '{}' >/etc/hedgehog/hedgehogd.json
systemctl stop hedgehogd
are hedgehogd ActiveState=inactive Result=success ExecMainStatus=0
logged "coils off" || fail "the journal does not say that the coils are off"
[ -z "$(ls -A /run/hedgehog)" ] || fail "in /run/hedgehog is left: $(ls -A /run/hedgehog)"

step "wrong settings: not started again and again"
echo '{ "nonsense": 1 }' >/etc/hedgehog/hedgehogd.json
systemctl start hedgehogd 2>/dev/null && fail "it starts with nonsense"
are hedgehogd ActiveState=failed ExecMainStatus=78 NRestarts=0
echo '{}' >/etc/hedgehog/hedgehogd.json
systemctl reset-failed hedgehogd
systemctl start hedgehogd

step "several balls: each its own socket and state; without settings none"
echo '{ "listen": { "tcp": ["127.0.0.1:7596"] }, "http": { "listen": "127.0.0.1:7597" } }' >/etc/hedgehog/0007.json
systemctl start hedgehogd@0007 hedgehogd@0008
are hedgehogd@0007 ActiveState=active
are hedgehogd@0008 ActiveState=inactive ConditionResult=no
hedgehogctl discover 2>/dev/null | tee /tmp/out
for socket in hedgehogd.sock 0007/hedgehogd.sock; do
  grep -q " /run/hedgehog/$socket$" /tmp/out || fail "/run/hedgehog/$socket was not found"
done
hedgehogctl --all stop
[ "$(hedgehogctl --all status --json | grep -c '"state":"disarmed"')" = 2 ] || fail "not both are stopped"
[ -e /var/lib/hedgehog/0007/state.json ] || fail "hedgehogd@0007 has no state of its own"
systemctl restart hedgehogd
[ -S /run/hedgehog/0007/hedgehogd.sock ] || fail "a restart of hedgehogd has removed the socket of hedgehogd@0007"

# plays SERIAL NAME: a pulse of 5 A flows through the board NAME.
plays() {
  eventually ctl "$1" arm
  eventually has "$1" state '"armed"'
  emulator status "$2" || fail "the emulator does not answer" # and resets the peak
  ctl "$1" pulse left || fail "$1: no pulse"
  emulator status "$2" || fail "the emulator does not answer"
  [[ $answer =~ \"peak_a\":\ ([4-9])\. ]] || fail "$1: its board has not carried the current: $answer"
}

step "boards that are plugged in: udev starts the service of one that has settings"
systemctl disable --quiet --now hedgehogd
systemctl stop hedgehogd@0007
systemctl start hedgehog-gamepad hedgehog-mqtt
are hedgehogd ActiveState=inactive # they wait for it, and do not start what was stopped
systemctl stop hedgehog-gamepad hedgehog-mqtt
systemctl reset-failed
echo '{ "name": "ball-9", "usb_serial": "0009" }' >/etc/hedgehog/devices.d/ball-9.json
echo '{ "backend": "usb", "device": "ball-9", "listen": { "tcp": ["127.0.0.1:7596"] }, "http": { "listen": "127.0.0.1:7597" } }' >/etc/hedgehog/0009.json
emulate board,name=nine,serial=0009,unplugged board,name=ten,serial=0010,unplugged
eventually plugged ten
condition_checked() { [ "$(property ConditionTimestampMonotonic "$1")" != 0 ]; }
eventually condition_checked hedgehogd@0010
are hedgehogd@0010 ActiveState=inactive ConditionResult=no Result=success
[ -z "$(systemctl list-units --plain --no-legend --state=failed 'hedgehogd*')" ] || fail "without settings it failed"
are hedgehogd@0009 ActiveState=inactive
eventually plugged nine
eventually is ActiveState active hedgehogd@0009
process=$(property MainPID hedgehogd@0009)
eventually has 0009 state '"disarmed"'
plays 0009 nine

step "unplugged: its service waits; plugged in again: the same process, disarmed"
emulator unplug nine || fail "the emulator does not answer"
eventually has 0009 state '"absent"'
are hedgehogd@0009 ActiveState=active "MainPID=$process"
eventually plugged nine
eventually has 0009 state '"disarmed"'
plays 0009 nine
are hedgehogd@0009 ActiveState=active "MainPID=$process" NRestarts=0
end_emulator

step "one of several balls at an MQTT broker: a service of its own, with settings of its own"
echo 'HEDGEHOG_MQTT_OPTIONS="--broker 127.0.0.1:1"' >/etc/hedgehog/mqtt.env
echo 'HEDGEHOG_MQTT_OPTIONS="--broker 127.0.0.2:1"' >/etc/hedgehog/mqtt-0009.env
systemctl enable --quiet --now hedgehog-mqtt@0009
eventually logged "no broker at 127.0.0.2" hedgehog-mqtt@0009
are hedgehog-mqtt@0009 ActiveState=active
rm /etc/hedgehog/mqtt.env /etc/hedgehog/mqtt-0009.env
systemctl enable --quiet --now hedgehogd

step "purged while all services run: nothing runs, nothing is left"
systemctl enable --quiet --now hedgehog-gamepad hedgehog-mqtt
eventually has_gamepad
services=(hedgehogd hedgehogd@0009 hedgehog-gamepad hedgehog-mqtt hedgehog-mqtt@0009)
for unit in "${services[@]}"; do are "$unit" ActiveState=active; done
rm /etc/hedgehog/0007.json /etc/hedgehog/0009.json /etc/hedgehog/devices.d/ball-9.json
dpkg --no-triggers --force-unsafe-io --purge hedgehogd hedgehog-tools >/tmp/out 2>&1 || { cat /tmp/out; fail "dpkg --purge"; }
for unit in "${services[@]}"; do are "$unit" ActiveState=inactive; done
! pgrep --list-full --full '^/usr/bin/hedgehog' || fail "it runs on"
! has_gamepad || fail "the gamepad is still there"
# hedgehog-mqtt is a user only while it runs.
accounts=$(getent passwd hedgehog hedgehog-gamepad hedgehog-mqtt || true; getent group hedgehog hedgehog-gamepad || true)
[ -z "$accounts" ] || fail "accounts left behind: $accounts"
left=$(find /etc /var/lib/hedgehog /run/hedgehog /usr/lib/systemd /usr/bin -xdev -name '*hedgehog*' 2>/dev/null | grep -v '^/etc/apt' || true)
[ -z "$left" ] || fail "left behind: $left"
step "all is well"
