#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: hedgehog-mqtt of that build at Debian's broker, through a partition of the network too (partition.sh), and a small
# fleet. Exit: 0 all is well, 69 no network namespace can be created here.
set -euo pipefail

[ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
build=$(cd "$1" && pwd)
work=$(mktemp -d)
broker=
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  if [ -n "$broker" ]; then
    kill -KILL "$broker" 2>/dev/null || true
    wait "$broker" 2>/dev/null || true
  fi
  rm -rf "$work"
}
trap clean_up EXIT

"$build/tests/mqtt/test_mqtt" --gtest_brief=1 --gtest_filter=-MqttPartition.*

printf 'listener 0 %s\nallow_anonymous true\nuser %s\n' "$work/broker.sock" "$(id -un)" >"$work/mosquitto.conf"
/usr/sbin/mosquitto -c "$work/mosquitto.conf" 2>"$work/broker.log" &
broker=$!
for _ in $(seq 300); do
  [ ! -S "$work/broker.sock" ] || break
  sleep 0.1
done
"$build/tests/mqtt/mqtt_fleet" --broker "$work/broker.sock" --broker-pid "$broker" --balls 20 --seconds 2 | tee "$work/fleet"
grep -q ' lost 0 ' "$work/fleet" || { cat "$work/broker.log"; echo "tests/mqtt: messages were lost" >&2; exit 1; }

"$(dirname -- "${BASH_SOURCE[0]}")/partition.sh" "$build"
