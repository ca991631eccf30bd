#!/bin/sh
# SPDX-License-Identifier: MIT
# The tests in two guests side by side, for each has one processor: the plug cycles, and all else.
#   test.sh -t SECONDS PROGRAM
# Exit: 0 all passed, 64 usage, else that of a guest that failed.
set -u

[ "$#,$1" = "3,-t" ] || { echo "test.sh -t SECONDS PROGRAM" >&2; exit 64; }
run=$(dirname -- "$0")/run.sh
"${run%run.sh}kernel.sh" >/dev/null || exit

log=$(mktemp)
trap 'rm -f "$log"' EXIT
"$run" -t "$2" "$3" --gtest_color=no --gtest_filter='Cycles.*' >"$log" 2>&1 &
cycles=$!
"$run" -t "$2" "$3" --gtest_color=no --gtest_filter='-Cycles.*'
result=$?
wait "$cycles" || result=$?
cat "$log"
exit "$result"
