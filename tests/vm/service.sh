#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# service.sh PACKAGES: hedgehogd and hedgehog-tools of the folder PACKAGES (make deb) under systemd, in a guest of run.sh -s:
# installed, started, killed, hung, reloaded, stopped; permissions, journal, several balls; purged. Exit: 0 all is well.
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
if [ "${1-}" != --inside ]; then
  [ $# -eq 1 ] || { echo "service.sh PACKAGES" >&2; exit 64; }
  exec "$here/run.sh" -t "${VM_SECONDS:-1200}" -s "$here/service.sh" --inside "$(cd "$1" && pwd)"
fi

packages=$2
export LC_ALL=C.UTF-8 HEDGEHOG_PATIENCE_MS=60000 DEBIAN_FRONTEND=noninteractive SYSTEMD_PAGER=cat
unset HEDGEHOG_ADDRESS RUNTIME_DIRECTORY XDG_RUNTIME_DIR
fail() {
  echo "tests/vm: $*"
  systemctl status --no-pager --full 'hedgehogd*' || true
  journalctl --no-pager -n 60 -u 'hedgehogd*' || true
  exit 1
}
step() { echo "tests/vm: $*"; }
property() { systemctl show --property "$1" --value "${2-hedgehogd}"; }
# eventually COMMAND...: the guest's clock jumps while it waits for files of the host, so the timeout is long.
eventually() {
  local until=$((SECONDS + 300))
  while [ "$SECONDS" -lt "$until" ]; do
    ! "$@" >/dev/null 2>&1 || return 0
    sleep 0.5
  done
  fail "not in time: $*"
}
# are UNIT PROPERTY=VALUE...
are() {
  local unit=$1 one
  shift
  for one; do
    [ "$(property "${one%%=*}" "$unit")" = "${one#*=}" ] || fail "$unit: not $one but $(property "${one%%=*}" "$unit")"
  done
}
is() { [ "$(property "$1")" = "$2" ]; }
logged() { journalctl --no-pager --output cat -u "${2-hedgehogd}" | grep -q "$1"; }
state_is() { hedgehogctl status --json | grep -q "\"state\":\"$1\""; }
# True when systemd has restarted it N times, and its process is not PID.
restarted() { is NRestarts "$1" && is ActiveState active && [ "$(property MainPID)" != "$2" ]; }

# The host's file; services may start in the guest.
rm -f /usr/sbin/policy-rc.d

step "install: enabled, started, ready"
# Triggers belong to other packages (man-db reads every page), and are slow on an emulated processor.
dpkg --no-triggers --force-unsafe-io --install "$packages"/hedgehogd_*.deb "$packages"/hedgehog-tools_*.deb >/tmp/out 2>&1 || { cat /tmp/out; fail "dpkg"; }
eventually is ActiveState active
[ "$(systemctl is-enabled hedgehogd)" = enabled ] || fail "it is not enabled"
are hedgehogd User=hedgehog
property StatusText | grep -q "^SIMULATOR: armed" || fail "its status is '$(property StatusText)'"
hedgehogctl pulse left

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
echo '{ "limits": { "curent_a": 9 } }' >/etc/hedgehog/hedgehogd.json
! systemctl reload hedgehogd 2>/tmp/out || fail "it reloads wrong settings"
eventually logged "did you mean"
are hedgehogd ActiveState=active "MainPID=$process"

step "stopped: orderly"
echo '{}' >/etc/hedgehog/hedgehogd.json
systemctl stop hedgehogd
are hedgehogd ActiveState=inactive Result=success ExecMainStatus=0
logged "coils off" || fail "the journal does not say that the coils are off"
[ ! -e /run/hedgehog ] || fail "/run/hedgehog is left"

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

step "purged: nothing runs, nothing is left"
rm /etc/hedgehog/0007.json
dpkg --no-triggers --force-unsafe-io --purge hedgehogd hedgehog-tools >/tmp/out 2>&1 || { cat /tmp/out; fail "dpkg --purge"; }
are hedgehogd@0007 ActiveState=inactive
! pgrep -x hedgehogd || fail "a daemon runs on"
left=$(find /etc /var/lib/hedgehog /run/hedgehog /usr/lib/systemd /usr/bin -xdev -name '*hedgehog*' 2>/dev/null | grep -v '^/etc/apt' || true)
[ -z "$left" ] || fail "left behind: $left"
step "all is well"
