#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# side_by_side.sh QUIET LOUD: makes both targets at once; what QUIET prints comes after it has ended. When one fails, the
# other still goes on to its end. Exit: 0 both made, else make's.
set -u

[ $# -eq 2 ] || { echo "side_by_side.sh QUIET LOUD" >&2; exit 64; }
# Each is a make of its own: they share no jobs.
unset MAKEFLAGS MAKELEVEL MFLAGS
log=$(mktemp)
make "$1" >"$log" 2>&1 &
quiet=$!
trap 'kill "$quiet" 2>/dev/null; rm -f "$log"' EXIT
code=0
make "$2" || code=$?
wait "$quiet" || code=$?
cat "$log"
exit "$code"
