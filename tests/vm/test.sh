#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs all tests, in three guests one after the other: programs that read hundreds of megabytes of the host get a guest
# whose memory no other test has filled, and tests of the firmware's image one with the emulated board (firmware.sh). The tests run real programs on a real clock, as those with the label `clock`
# (tests/run.sh): failed ones are repeated once, in a guest of their own, and named in the table of stages, with what they
# print if they fail again.
#   test.sh -t SECONDS PROGRAM
# Exit: 0 all passed, at once or the second time; 64 usage; else a guest's.
set -u

[ "$#,$1" = "3,-t" ] || { echo "test.sh -t SECONDS PROGRAM" >&2; exit 64; }
limit=$2 program=$3
here=$(dirname -- "${BASH_SOURCE[0]}")
firmware='FirmwareBoard.*'
large='GamepadBrowser.*:GamepadGame.*'
log=$(mktemp)
table=${HEDGEHOG_STAGES:-/dev/null}
trap 'rm -f "$log"' EXIT

# run_in SCRIPT FILTER: the tests of FILTER in a guest of run.sh or firmware.sh.
run_in() { "$here/$1" -t "$limit" "$program" --gtest_color=no --gtest_filter="$2" | tee "$log"; return "${PIPESTATUS[0]}"; }

# guest SCRIPT FILTER: returns its exit code; adds failed tests to `failed`, and the number of tests to `ran`.
failed=() ran=0
guest() {
  local result=0 before=${#failed[@]} one
  run_in "$1" "$2" || result=$?
  ran=$((ran + $(sed -nE 's/^\[==========\] ([0-9]+) tests? from .* ran\..*/\1/p' "$log" | head -1) + 0))
  [ "$result" -ne 0 ] || return 0
  # A guest that ended early has not run all tests.
  grep -q '^\[==========\] .* ran\.' "$log" || { record 1; exit "$result"; }
  while read -r one; do failed+=("$one"); done < <(
    sed -nE 's/^\[  FAILED  \] ([[:alnum:]_/]+\.[[:alnum:]_/]+).*/\1/p' "$log" | sort -u)
  [ "${#failed[@]}" -gt "$before" ] || { record 1; exit "$result"; }
}

# record FAILED: the number of tests, and how many of them failed, for the table.
record() { printf 'tests\t%d\t%d\t0\n' "$ran" "$1" >>"$table"; }

guest run.sh "-$large:$firmware"
guest run.sh "$large"
guest firmware.sh "$firmware"
if [ "${#failed[@]}" -eq 0 ]; then
  record 0
  exit 0
fi
printf 'repeated\tusb %s\n' "${failed[@]}" >>"$table"
echo "run once more: ${failed[*]}"
filter=$(IFS=:; echo "${failed[*]}")
result=0
run_in firmware.sh "$filter" || result=$?
again=$(grep -c '^\[  FAILED  \] .*ms)' "$log")
# A test that crashed prints no such line.
[ "$result" -eq 0 ] || [ "$again" -gt 0 ] || again=1
record "$again"
awk -v code="$result" '
  /^\[ RUN / { text = "" }
  { text = text "failure\t" $0 "\n" }
  /^\[  FAILED  \] .*ms\)/ { printf "%s", text; text = ""; shown = 1 }
  END { if (code && !shown) printf "%s", text }' "$log" >>"$table"
exit "$result"
