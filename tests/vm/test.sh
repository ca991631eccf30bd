#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All tests in one guest. They run real programs on a real clock, as what has the label `clock` does (tests/run.sh): those
# that fail are run once more, in a guest of their own, and named in the table of stages.
#   test.sh -t SECONDS PROGRAM
# Exit: 0 all passed, at once or the second time; 64 usage; else the guest's.
set -u

[ "$#,$1" = "3,-t" ] || { echo "test.sh -t SECONDS PROGRAM" >&2; exit 64; }
run=$(dirname -- "${BASH_SOURCE[0]}")/run.sh
log=$(mktemp)
trap 'rm -f "$log"' EXIT

"$run" -t "$2" "$3" --gtest_color=no | tee "$log"
result=${PIPESTATUS[0]}
[ "$result" -ne 0 ] || exit 0

# A guest that ended early has not run them all.
grep -q '^\[==========\] .* ran\.' "$log" || exit "$result"
mapfile -t failed < <(sed -nE 's/^\[  FAILED  \] ([[:alnum:]_/]+\.[[:alnum:]_/]+).*/\1/p' "$log" | sort -u)
[ "${#failed[@]}" -gt 0 ] || exit "$result"
[ -z "${HEDGEHOG_STAGES-}" ] || printf 'repeated\tusb %s\n' "${failed[@]}" >>"$HEDGEHOG_STAGES"
echo "run once more: ${failed[*]}"
filter=$(IFS=:; echo "${failed[*]}")
"$run" -t "$2" "$3" --gtest_color=no --gtest_filter="$filter"
