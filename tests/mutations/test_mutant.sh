#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_mutant.sh NUMBER: checks whether a test fails with mutant NUMBER of build/mutations/chosen. Appends a line to
# build/mutations/results: verdict, test, then the mutant as in `chosen`, separated by tabs. Verdicts: killed, late (a test
# did not end), survived, nonviable (does not compile), left (no time left), broken (could not be tested).
set -euo pipefail

work=build/mutations
mutant=$(sed -n "${1}p" "$work/chosen")
IFS=$'\t' read -r file judges compiled _ offset length put _ _ <<<"$mutant"
folder=$PWD/$work/$1
# shellcheck source=tests/relink.sh
. tests/relink.sh
list_commands "$work/commands"

verdict() { # verdict judge
  printf '%s\t%s\t%s\n' "$1" "$2" "$mutant" >>"$work/results"
  rm -rf "$folder"
  [ "$1" != survived ] || printf '%s\n' "$mutant" | awk -F '\t' '{ printf "SURVIVED  %s:%d  %s: %s\n", $1, $4, $8, $9 }'
  exit 0
}

[ -z "${MUTATIONS_END-}" ] || [ "$(date +%s)" -lt "$MUTATIONS_END" ] || verdict left -
mkdir -p "$folder/$(dirname -- "$file")"
{
  head -c "$offset" "$file"
  printf '%s' "$put"
  tail -c "+$((offset + length + 1))" "$file"
} >"$folder/$file"

# The mutated header precedes the tree's on the include path; not inlined, its functions replace those of the tests.
source=$folder/$file
options=()
if [ "$compiled" != "$file" ]; then
  source=$PWD/$compiled
  options=("-I$folder" -fno-inline)
fi
compile_as_built "$compiled" "$source" "$folder/mutant.o" "${options[@]}" >"$folder/log" 2>&1 || case $? in
  2) verdict broken "$compiled is not compiled by itself" ;;
  *) verdict nonviable - ;;
esac

while read -r program filter limit_s; do
  [ -x "$folder/test_$program" ] ||
    link_as_built "tests/test_$program" "$folder/test_$program" "$folder/mutant.o" >"$folder/log" 2>&1 ||
    verdict broken "test_$program does not link"
  status=0
  # Runs in the folder, which is removed with the files that a test writes.
  # Suppresses the shell's message about a test ended by a signal.
  { (cd "$folder" && timeout "$limit_s" "./test_$program" --gtest_filter="$filter" --gtest_brief=1 \
    --gtest_fail_fast) >"$folder/log" 2>&1; } 2>/dev/null || status=$?
  red=$(sed -nE 's/^\[  FAILED  \] ([^ ,]+).*/\1/p' "$folder/log" | head -n 1)
  [ "$status" -ne 124 ] || verdict late "test_$program"
  [ "$status" -eq 0 ] || verdict killed "test_$program ${red:-ended with $status}"
done <"$work/limits.$judges"
verdict survived -
