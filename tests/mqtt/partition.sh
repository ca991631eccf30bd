#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# partition.sh BUILD: hedgehog-mqtt and its broker on two machines with a cable between them: network namespaces and a veth pair,
# whose link the tests MqttPartition.* take down and up. No packet leaves this machine. Exit: 0 passed, 69 no such namespace can be
# created here.
set -euo pipefail

if [ "${1-}" != --inside ]; then
  [ $# -eq 1 ] || { echo "partition.sh BUILD" >&2; exit 64; }
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo -n)
  "${as_root[@]}" unshare --net --mount true || { echo "tests/mqtt: no network namespace" >&2; exit 69; }
  # All processes in the namespace end with its first one.
  "${as_root[@]}" unshare --net --mount --pid --fork --kill-child --mount-proc "${BASH_SOURCE[0]}" --inside "$(realpath "$1")"
  exit
fi

# For the names of namespaces.
mount -t tmpfs none /run
ip link set lo up
ip netns add broker
ip link add cable type veth peer name cable netns broker
ip address add 192.0.2.1/24 dev cable
ip link set cable up
ip -n broker address add 192.0.2.2/24 dev cable
ip -n broker link set cable up

"$2/tests/mqtt/test_mqtt" --gtest_brief=1 --gtest_filter='MqttPartition.*' | tee /run/output
grep -q '^\[  PASSED  \] [1-9]' /run/output || { echo "tests/mqtt: no such test" >&2; exit 1; }
