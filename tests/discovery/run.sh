#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: tests the daemon's announcement, `hedgehogctl discover`, its tunnel and mdns:// in the client libraries with Debian's Avahi,
# on a separate message bus and in a separate network namespace: no packet leaves this machine. Exit: 0 passed, 69 no such namespace
# can be created here.
set -euo pipefail

if [ "${1-}" != --inside ]; then
  [ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
  build=$(cd "$1" && pwd)
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
  work=$(mktemp -d)
  # Avahi's own user must be able to read it.
  chmod 755 "$work"
  trap '"${as_root[@]}" rm -rf "$work"' EXIT
  "${as_root[@]}" unshare --net --mount true || { echo "tests/discovery: no network namespace" >&2; exit 69; }
  # All processes in the namespace end with its first one.
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
clients=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/../../clients" && pwd)
# found FILTER: evaluates a Python expression with `network`, the discovered balls, and `names`, their names.
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

step "the client libraries find it, and play on it"
mkdir "$work/state"
openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 30 -subj /CN=lab -keyout "$work/state/key.pem" \
  -out "$work/state/certificate.pem" 2>/dev/null
HEDGEHOG_TOKEN=hht_of-a-test
HEDGEHOG_FINGERPRINT=$(openssl x509 -in "$work/state/certificate.pem" -outform DER | sha256sum | cut -d ' ' -f 1)
export HEDGEHOG_TOKEN HEDGEHOG_FINGERPRINT PYTHONDONTWRITEBYTECODE=1
printf 'arcade play sha256:%s 2026-11-24\n' "$(printf %s "$HEDGEHOG_TOKEN" | sha256sum | cut -d ' ' -f 1)" >"$work/state/tokens"
STATE_DIRECTORY=$work/state "$build/daemon/hedgehogd" --simulate --speed 1 --listen tls://192.0.2.7:17590 >"$work/daemon.log" 2>&1 &
daemon=$!
eventually found 'len(names) == 1'
name=$("$ctl" discover --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["network"][0]["name"])')
# in_python ADDRESS, in_javascript ADDRESS, in_cpp ADDRESS: play a pulse.
in_python() {
  PYTHONPATH=$clients/python python3 -c 'import sys, hedgehog; hedgehog.Ball(sys.argv[1]).pulse("left", on_close="finish")' "$1"
}
in_javascript() {
  node --input-type=module -e 'const { Ball } = await import(process.argv[1]);
const ball = await Ball.connect({ address: process.argv[2] });
await ball.pulse("left");
ball.close();' "$clients/js/src/node.js" "$1"
}
in_cpp() { "$ctl" --address "$1" pulse left; }
for library in python javascript cpp; do
  for address in mdns:// "mdns://$name"; do
    "in_$library" "$address" >"$work/$library.log" 2>&1 || fail "$library: $address"
  done
  ! "in_$library" mdns://another >"$work/$library.log" 2>&1 || fail "$library: another ball was found"
  grep -qF "no ball \"another\" answers on this network (mDNS, 1 s); there are: \"$name\"" "$work/$library.log" || fail "$library: $name"
done

step "of several, one has to be chosen"
announce ball-9 17591 0009
second=$!
eventually found 'len(names) == 2'
for library in python javascript cpp; do
  ! "in_$library" mdns:// >"$work/$library.log" 2>&1 || fail "$library: one was chosen"
  grep -q 'several balls answer on this network: .*"ball-9" (serial 0009, tls://192.0.2.7:17591)' "$work/$library.log" || fail "$library"
  "in_$library" "mdns://$name" >"$work/$library.log" 2>&1 || fail "$library: $name of several"
  ! HEDGEHOG_FINGERPRINT=${HEDGEHOG_FINGERPRINT//[0-9]/a} "in_$library" "mdns://$name" >"$work/$library.log" 2>&1 ||
    fail "$library: another fingerprint was spoken to"
  grep -q "another fingerprint" "$work/$library.log" || fail "$library: fingerprint"
done
kill "$second"
wait "$second" || fail "announce failed"

step "on another machine a tunnel finds it for games without token, search and TLS"
ip netns add game
ip link set cable netns game
on_game() { ip netns exec game "$@"; }
on_game ip link set lo up
on_game ip address add 192.0.2.8/24 dev cable
on_game ip link set cable up
eventually on_game "$ctl" --address "mdns://$name" status
# Not by on_game, a function: the signal below is for the tunnel itself.
ip netns exec game "$ctl" tunnel "mdns://$name" >"$work/tunnel.out" 2>"$work/tunnel.log" &
tunnel=$!
eventually grep -qx HEDGEHOG_ADDRESS=127.0.0.1:7586 "$work/tunnel.out"
in_game() { on_game env -u HEDGEHOG_TOKEN -u HEDGEHOG_FINGERPRINT HEDGEHOG_ADDRESS=127.0.0.1:7586 "$@"; }
in_game "$ctl" pulse left || fail "no pulse"

step "a lost network ends the connections of those who only read, and of those who only send"
in_game "$ctl" telemetry >"$work/telemetry.out" 2>"$work/reader.log" &
reader=$!
in_game env PYTHONPATH="$clients/python" python3 -c '
import time, hedgehog
ball = hedgehog.Ball()
while ball.rumble("engine", 0.3, "back"):
    print("sent", flush=True)
    time.sleep(0.1)' >"$work/rumble.out" 2>"$work/sender.log" &
sender=$!
eventually test -s "$work/telemetry.out"
eventually test -s "$work/rumble.out"
ip link set ball down
ended() { ! kill -0 "$1"; }
eventually ended "$reader"
eventually ended "$sender"
wait "$reader" && fail "the end was not reported" || [ $? = 69 ] || fail "exit of telemetry"
grep -q "the daemon closed the connection" "$work/reader.log" || fail "reader"
ip link set ball up
eventually in_game "$ctl" pulse left
kill "$tunnel"
wait "$tunnel" && fail "exit of the tunnel" || [ $? = 130 ] || fail "exit of the tunnel"
kill "$daemon"
wait "$daemon" || fail "the daemon failed"
step "all is well"
