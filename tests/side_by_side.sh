#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# side_by_side.sh QUIET LOUD: makes both targets concurrently; the output of QUIET is printed after LOUD has ended. When one
# fails, the other is still completed. Exit: 0 both made, else make's.
set -u

[ $# -eq 2 ] || { echo "side_by_side.sh QUIET LOUD" >&2; exit 64; }
# Two independent makes, which share no job slots.
unset MAKEFLAGS MAKELEVEL MFLAGS
log=$(mktemp)
# A separate process group, so that all its processes can be ended.
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
