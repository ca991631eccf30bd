#!/bin/sh
# SPDX-License-Identifier: MIT
# in_time.sh NAME: checks whether the stage NAME may still begin. No stage begins after HEDGEHOG_DEADLINE (seconds since 1970),
# if set; skipped stages are listed in the table of stages (HEDGEHOG_STAGES). Exit: 0 it may begin, 1 it is too late.
set -eu

[ $# -eq 1 ] || { echo "in_time.sh NAME" >&2; exit 64; }
[ -n "${HEDGEHOG_DEADLINE-}" ] || exit 0
[ "$(date +%s)" -ge "$HEDGEHOG_DEADLINE" ] || exit 0
echo "not begun for want of time: $1" >&2
[ -z "${HEDGEHOG_STAGES-}" ] || printf 'late\t%s\n' "$1" >>"$HEDGEHOG_STAGES"
exit 1
