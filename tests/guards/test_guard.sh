#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_guard.sh FOLDER: checks that tests fail without the guard that remove_guards.sh removed in FOLDER/source. Creates
# FOLDER/seen_red when each line of FOLDER/red has a failing test.
set -euo pipefail

folder=$1
top=$PWD
# shellcheck source=tests/relink.sh
. tests/relink.sh
list_commands build/guards/commands
dev=$relink_dev
hazard=$(<"$folder/hazard")
guard=$(<"$folder/guard")

give_up() { # sentence log
  touch "$folder/broken"
  {
    printf 'BROKEN    %-34.34s %s: %s\n' "$hazard" "$guard" "$1"
    tail -n 20 "$2"
  } >&2
  exit 1
}

# Without the guard, variables may be unused.
objects=()
while IFS= read -r file; do
  object=$top/$folder/$(basename -- "$file").o
  compile_as_built "$file" "$top/$folder/source/$file" "$object" >"$folder/log" 2>&1 || case $? in
    2) give_up "$file is compiled in a batch, or not at all: cmake --preset dev" /dev/null ;;
    *) give_up "does not compile without it" "$folder/log" ;;
  esac
  objects+=("$object")
done <"$folder/files"

# link PLACE: links that program of the build with the changed objects.
link() {
  link_as_built "$1" "$top/$folder/$1" "${objects[@]}" >"$folder/log" 2>&1 || case $? in
    2) give_up "there is no $1" /dev/null ;;
    *) give_up "does not link without it" "$folder/log" ;;
  esac
}

# The names of the failed tests of one program.
failures_of() { # program filter
  local program=$folder/tests/test_$1 out status=0
  if [ "$1" = e2e ]; then
    # The end-to-end tests run the daemon, which contains the guard.
    [ -e "$folder/daemon/hedgehogd" ] || link daemon/hedgehogd
    program=$dev/tests/test_e2e
  elif [ ! -e "$program" ]; then
    link "tests/test_$1"
  fi
  out=$(HEDGEHOG_PROGRAMS=$folder timeout 300 "$program" --gtest_filter="$2" --gtest_brief=1 2>&1) || status=$?
  [ "$status" -ne 0 ] || return 0
  [ "$status" -ne 124 ] || give_up "test_$1 $2 did not end" /dev/null
  printf '%s\n' "$out" | sed -nE 's/^\[  FAILED  \] ([^ ,]+).* \([0-9]+ ms\)$/\1/p' | sort -u | grep . ||
    echo "test_$1 ended with $status"
}

found='' blind=''
while read -r program filter; do
  names=$(failures_of "$program" "$filter")
  # `give_up` in a command substitution does not end this script.
  [ ! -e "$folder/broken" ] || exit 1
  [ -n "$names" ] || blind+=" $program $filter;"
  found+=$names$'\n'
done <"$folder/red"
found=$(printf '%s' "$found" | grep . || true)
if [ -n "$blind" ]; then
  printf 'SURVIVED  %-34.34s %s:%s\n' "$hazard" "$guard" "$blind"
  exit 1
fi
touch "$folder/seen_red"
printf 'red %4d  %-34.34s %s: %s\n' "$(printf '%s\n' "$found" | wc -l)" "$hazard" "$guard" \
  "$(printf '%s\n' "$found" | head -n 2 | paste -sd ' ')"
