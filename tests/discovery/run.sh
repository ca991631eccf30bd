#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: the daemon's announcement and `hedgehogctl discover` with Debian's Avahi, on a bus and in a network
# namespace of their own: nothing leaves this machine. Exit: 0 all is well, 69 such a namespace cannot be made here.
set -euo pipefail

if [ "${1-}" != --inside ]; then
  [ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
  build=$(cd "$1" && pwd)
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
  work=$(mktemp -d)
  # Avahi's own user reads in it.
  chmod 755 "$work"
  trap '"${as_root[@]}" rm -rf "$work"' EXIT
  "${as_root[@]}" unshare --net --mount true || { echo "tests/discovery: no network namespace" >&2; exit 69; }
  # All that is started there ends with its first process.
  "${as_root[@]}" unshare --net --mount --pid --fork --kill-child --mount-proc "${BASH_SOURCE[0]}" --inside "$build" "$work"
  exit
fi

build=$2 work=$3
fail() { echo "tests/discovery: $*" >&2; cat "$work"/*.log >&2; exit 1; }
step() { echo "tests/discovery: $*"; }
# eventually COMMAND...
eventually() {
  local until=$((SECONDS + 60))
  while [ "$SECONDS" -lt "$until" ]; do
    ! "$@" >/dev/null 2>&1 || return 0
    sleep 0.1
  done
  fail "not within a minute: $*"
}

ip link set lo up
ip link add ball type veth peer name cable
ip address add 192.0.2.7/24 dev ball
ip link set ball up
ip link set cable up
mount -t tmpfs none /run
mkdir -p /run/dbus /run/hedgehog
cat >"$work/bus.conf" <<'END'
<busconfig>
  <type>system</type>
  <listen>unix:path=/run/dbus/system_bus_socket</listen>
  <policy context="default">
    <allow user="*"/><allow own="*"/><allow send_destination="*" eavesdrop="false"/>
    <allow send_type="signal"/><allow send_type="method_return"/><allow send_type="error"/>
    <allow receive_type="method_call"/><allow receive_type="method_return"/><allow receive_type="error"/><allow receive_type="signal"/>
  </policy>
</busconfig>
END
printf '[server]\nhost-name=lab\nallow-interfaces=ball\nuse-ipv6=no\n' >"$work/avahi.conf"
unset DBUS_SYSTEM_BUS_ADDRESS HEDGEHOG_ADDRESS
export RUNTIME_DIRECTORY=/run/hedgehog

ctl=$build/clients/ctl/hedgehogctl
# found FILTER: an expression over `network`, the balls found there.
found() {
  { "$ctl" discover --json 2>>"$work/ctl.log" || [ $? = 69 ]; } | python3 -c '
import json, sys
network = json.load(sys.stdin)["network"]
names = {one["name"] for one in network}
sys.exit(0 if eval(sys.argv[1]) else 1)' "$1"
}
avahi() {
  avahi-daemon --file="$work/avahi.conf" --no-drop-root --no-chroot --no-rlimits >>"$work/avahi.log" 2>&1 &
  avahi=$!
  eventually avahi-browse --all --terminate
}
announce() { # NAME PORT SERIAL
  "$build/tests/discovery/announce" "$@" 2>>"$work/announce.log" &
}

dbus-daemon --config-file="$work/bus.conf" --nofork --nopidfile 2>"$work/bus.log" &
eventually test -S /run/dbus/system_bus_socket

step "without Avahi"
message=$("$ctl" discover 2>&1) && fail "a ball was found" || [ $? = 69 ] || fail "exit"
grep -q "not searched: .*Daemon not running" <<<"$message" || fail "$message"

step "a ball is found, with its records"
avahi
found 'not network' || fail "a ball was found before one was there"
announce ball-7 17586 0007
first=$!
eventually found 'network == [{"name": "ball-7", "host": "lab.local", "address": "tls://192.0.2.7:17586", "serial": "0007", "protocol": "1.0", "tls": True}]'
"$ctl" discover | grep ball-7

step "another of the same name has another"
announce ball-7 17587 0008
second=$!
eventually found 'names == {"ball-7", "ball-7 #2"}'

step "one that ends is withdrawn"
kill "$first"
wait "$first" || fail "announce failed"
eventually found 'names == {"ball-7 #2"}'

step "Avahi restarts: announced again"
kill "$avahi"
wait "$avahi" || true
avahi
eventually found 'len(names) == 1'

step "a killed one is withdrawn too"
kill -KILL "$second"
eventually found 'not names'
step "all is well"
