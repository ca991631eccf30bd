#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# side_by_side.sh QUIET LOUD: makes both targets at once; what QUIET prints comes after LOUD has ended. When one fails,
# the other still goes on to its end. Exit: 0 both made, else make's.
set -u

[ $# -eq 2 ] || { echo "side_by_side.sh QUIET LOUD" >&2; exit 64; }
# Each is a make of its own: they share no jobs.
unset MAKEFLAGS MAKELEVEL MFLAGS
log=$(mktemp)
# A group of its own, so that all of it can be ended.
set -m
make "$1" >"$log" 2>&1 &
quiet=$!
set +m
trap '[ -z "$quiet" ] || kill -- "-$quiet" 2>/dev/null; cat "$log"; rm -f "$log"' EXIT
trap 'exit 130' INT TERM
code=0
make "$2" || code=$?
wait "$quiet" || code=$?
quiet=''
exit "$code"
