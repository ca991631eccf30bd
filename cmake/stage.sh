#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# stage.sh NAME COMMAND...: runs the command, with its exit code. With HEDGEHOG_STAGES=FILE appends a line to that file:
# stage, NAME, wall-clock seconds, processor seconds, exit code, separated by tabs.
set -u

[ $# -ge 2 ] || { echo "stage.sh NAME COMMAND..." >&2; exit 64; }
name=$1
shift
[ -n "${HEDGEHOG_STAGES-}" ] || exec "$@"

begun=$EPOCHREALTIME
"$@"
code=$?
ended=$EPOCHREALTIME
# Of this shell, then of its children: "1m2.345s 0m0.678s", user and system.
times >"$HEDGEHOG_STAGES.$$"
awk -v name="$name" -v begun="${begun/,/.}" -v ended="${ended/,/.}" -v code="$code" '
  { split($0, part, /[ms ]+/) }
  END {
    printf "stage\t%s\t%.1f\t%.1f\t%d\n", name, ended - begun,
      60 * part[1] + part[2] + 60 * part[3] + part[4], code
  }' "$HEDGEHOG_STAGES.$$" >>"$HEDGEHOG_STAGES"
rm -f "$HEDGEHOG_STAGES.$$"
exit "$code"
