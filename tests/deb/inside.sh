#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# inside.sh: tests the packages in /packages on a system that never had them; run by run.sh in a fresh root.
set -euo pipefail

fail() { echo "tests/deb: $*" >&2; exit 1; }
step() { echo "tests/deb: $*"; }
quietly() { "$@" >/tmp/out 2>&1 || { cat /tmp/out; fail "$*"; }; }
# Prints every file and account of this project, except the packages themselves.
ours() {
  find / -xdev -path /packages -prune -o -name '*hedgehog*' -print | sort
  getent passwd | grep hedgehog || true
  getent group | grep hedgehog || true
}

[ -z "$(ours)" ] || fail "this system has known them"
quietly apt-get update

step "install"
begun=$SECONDS
quietly apt-get install -y --no-install-recommends /packages/before/*.deb
[ -e /etc/systemd/system/multi-user.target.wants/hedgehogd.service ] || fail "the service is not enabled"
for unit in hedgehog-gamepad hedgehog-mqtt; do
  [ ! -e "/etc/systemd/system/multi-user.target.wants/$unit.service" ] || fail "$unit is enabled"
done
for user in hedgehog hedgehog-gamepad; do getent passwd "$user" >/dev/null || fail "there is no user $user"; done
! systemd-analyze verify hedgehogd.service 2>&1 | grep -i hedgehog || fail "systemd-analyze verify"

# Starts the daemon as its unit does, without systemd.
daemon=
start() {
  install -d -o hedgehog -g hedgehog /run/hedgehog /var/lib/hedgehog
  mkfifo /tmp/listening
  exec 3<>/tmp/listening
  RUNTIME_DIRECTORY=/run/hedgehog STATE_DIRECTORY=/var/lib/hedgehog CONFIGURATION_DIRECTORY=/etc/hedgehog \
    setpriv --reuid=hedgehog --regid=hedgehog --init-groups hedgehogd --listen 127.0.0.1:0 >/tmp/listening 2>/tmp/daemon.log &
  daemon=$!
  read -r -t 120 -u 3 line || { cat /tmp/daemon.log; fail "the daemon did not start"; }
  echo "$line"
}
stop() {
  kill "$daemon"
  wait "$daemon" || { cat /tmp/daemon.log; fail "the daemon did not end as it should"; }
  exec 3>&-
  rm -f /tmp/listening
}

start
hedgehogctl pulse left
echo "from apt install to the first pulse: $((SECONDS - begun)) s"
stop

step "upgrade"
echo '{ "limits": { "current_a": 10 } }' >/etc/hedgehog/hedgehogd.json
quietly apt-get install -y --no-install-recommends /packages/*.deb
dpkg-query --show --showformat '${Package} ${Version}\n' 'hedgehog*' libhedgehog-dev python3-hedgehog
grep -q '"current_a": 10' /etc/hedgehog/hedgehogd.json || fail "the upgrade has overwritten the settings"
start
[ "$(hedgehogctl status --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["state"])')" = armed ] || fail "it is not armed"
hedgehogctl pulse left
python3 -c '
from hedgehog import Ball
with Ball() as ball:
    ball.pulse("left", level=0.5)
    print("python:", ball.status()["state"])'
hedgehogctl check || [ $? = 1 ] || fail "check"
if [ -e /packages/figures.sh ]; then
  step "figures"
  cp /etc/hedgehog/hedgehogd.json /packages/settings.json
  bash /packages/figures.sh >/packages/figures.json || fail "figures.sh"
fi
for program in hedgehog-gamepad hedgehog-mqtt hedgehog-orientation hedgehog-study hedgehog-design hedgehog-simboard hedgehog-racer; do quietly "$program" --version; done
stop

step "remove, purge"
quietly apt-get remove -y hedgehogd
[ -e /etc/hedgehog/hedgehogd.json ] || fail "removing has taken the settings"
quietly apt-get purge -y hedgehogd hedgehog-tools hedgehog-racer libhedgehog-dev python3-hedgehog
left=$(ours)
[ -z "$left" ] || fail "left behind: $left"
