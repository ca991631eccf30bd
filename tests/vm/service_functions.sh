#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# To be sourced: functions for the steps of service.sh, in the guest: units, packages, emulated boards.
# usbip: the path of hedgehog-usbip.
fail() {
  echo "tests/vm: $*"
  systemctl status --no-pager --full 'hedgehog*' || true
  journalctl --no-pager -n 60 -u 'hedgehog*' || true
  exit 1
}
step() {
  echo "tests/vm: $*"
  begun=@$(date +%s.%6N)
}
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
is() { [ "$(property "$1" "${3-hedgehogd}")" = "$2" ]; } # PROPERTY VALUE [UNIT]
# logged TEXT [UNIT]: in this step.
logged() { journalctl --no-pager --output cat --since "$begun" -u "${2-hedgehogd}" | grep -q "$1"; }
ctl() { hedgehogctl --address "/run/hedgehog/$1/hedgehogd.sock" "${@:2}"; } # SERIAL VERB...
has() { ctl "$1" status --json | grep -q "\"$2\":$3[,}]"; }               # SERIAL KEY VALUE, of the status
# True when systemd has restarted it N times, and its process is not PID.
restarted() { is NRestarts "$1" && is ActiveState active && [ "$(property MainPID)" != "$2" ]; }

# install PACKAGE...: files. Triggers belong to other packages (man-db reads every page), and are slow on an emulated processor.
# Changed settings are kept.
install() {
  dpkg --no-triggers --force-unsafe-io --force-confold --install "$@" >/tmp/out 2>&1 || { cat /tmp/out; fail "dpkg"; }
}
runs() { [ "$(readlink "/proc/$1/exe")" = "$2" ]; } # PID FILE
# renewed UNIT PID: active, with another process than PID, which runs the installed file.
renewed() {
  local process
  process=$(property MainPID "$1")
  [ "$process" != "$2" ] || fail "$1: its process is still that of the older version"
  are "$1" ActiveState=active
  # A unit of Type=simple is active before its process executes the file.
  eventually runs "$process" "/usr/bin/${1%@*}"
  are "$1" ActiveState=active NRestarts=0 "MainPID=$process"
}
has_gamepad() { grep -q '^N: Name="Hedgehog haptic ball"$' /proc/bus/input/devices; }

# emulator COMMAND...: its answer is `answer`. Not in a subshell, which would not have the coprocess.
emulator() { echo "$*" >&"${EMULATOR[1]}" && read -r -t 300 -u "${EMULATOR[0]}" answer; }
# emulate DEVICE...: starts it.
emulate() {
  coproc EMULATOR { exec "${usbip:?}" --vhci "$@" 2>/tmp/emulator; }
  emulator_process=$EMULATOR_PID answer=
  read -r -t 300 -u "${EMULATOR[0]}" answer || true
  [ "$answer" = ready ] || fail "the emulator does not start: $(cat /tmp/emulator)"
}
end_emulator() {
  emulator quit || fail "the emulator does not answer"
  wait "$emulator_process" || fail "the emulator: $(cat /tmp/emulator)"
}
plugged() { emulator plug "$1" && [ "$answer" = ok ]; }
