#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Checks that the tests execute every line of the sources marked `covered` in scope.txt. Needs `make dev`: only those sources
# are recompiled, with counters, and linked into the test programs of that build; their tests run once.
# Exit: 0 every line, 1 not (lists the others), 70 a test fails, or a source does not compile with counters.
set -euo pipefail

cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."
work=build/coverage
rm -rf "$work"
mkdir -p "$work"
export CCACHE_DISABLE=1 RC_PARAMS=seed=7
# shellcheck source=tests/mutations/scope.sh
. tests/mutations/scope.sh
scope_into "$work"
# shellcheck source=tests/relink.sh
. tests/relink.sh
list_commands "$work/commands"

give_up() { # sentence log
  echo "coverage: $1" >&2
  tail -n 20 "$2" >&2
  exit 70
}

objects=()
while read -r file; do
  object=$PWD/$work/${file//\//_}.o
  compile_as_built "$file" "$PWD/$file" "$object" -fprofile-instr-generate -fcoverage-mapping >"$work/log" 2>&1 ||
    give_up "$file does not compile with counters" "$work/log"
  objects+=("$object")
done <"$work/covered"

awk -F '\t' 'FILENAME == ARGV[1] { covered[$0]; next } $1 in covered { print $2 }' "$work/covered" "$work/files" | sort -u |
  sed "s|^|$work/judges.|" | xargs cat | sort -u >"$work/judges"
# An archive before the build's libraries: the linker takes from it what a program needs.
ar rcs "$work/covered.a" "${objects[@]}"
programs=()
while read -r program; do
  link_as_built "tests/test_$program" "$PWD/$work/test_$program" -fprofile-instr-generate "$PWD/$work/covered.a" >"$work/log" 2>&1 ||
    give_up "test_$program does not link" "$work/log"
  programs+=(${programs:+-object} "$work/test_$program")
done < <(cut -d ' ' -f 1 "$work/judges" | sort -u)

number=0
while read -r program filter; do
  number=$((number + 1))
  LLVM_PROFILE_FILE=$work/$number.profraw "$work/test_$program" --gtest_filter="$filter" --gtest_brief=1 >"$work/log" 2>&1 ||
    give_up "test_$program fails: $filter" "$work/log"
done <"$work/judges"
llvm-profdata merge -sparse "$work"/*.profraw -o "$work/profile"

# DA:LINE,COUNT; a line of several regions has the count of the one that was executed most.
xargs llvm-cov export -format=lcov -instr-profile "$work/profile" "${programs[@]}" <"$work/covered" >"$work/lcov" 2>"$work/log" ||
  give_up "llvm-cov fails" "$work/log"
touch "$work/constants"
awk -v top="$PWD/" '
  FILENAME == ARGV[1] { wanted[$0]; next }
  FILENAME == ARGV[2] {
    split($0, part, "\t")
    inside = line = 0
    while ((getline text <part[1]) > 0) {
      ++line
      if (text == part[2]) inside = 1
      if (inside) constant[part[1], line]
      if (text ~ /^}/) inside = 0
    }
    next
  }
  /^SF:/ { file = substr($0, 4); if (index(file, top) == 1) file = substr(file, length(top) + 1) }
  /^DA:/ && file in wanted {
    split(substr($0, 4), part, ",")
    if ((file, part[1]) in constant) next
    if (!((file, part[1]) in count)) { ++lines[file]; at[file, lines[file]] = part[1] }
    if (part[2] + 0 > count[file, part[1]] + 0) count[file, part[1]] = part[2]
    count[file, part[1]] += 0
  }
  END {
    for (file in wanted) {
      missed = 0
      for (k = 1; k <= lines[file]; ++k)
        if (count[file, at[file, k]] == 0) { ++missed; print "NOT EXECUTED  " file ":" at[file, k] | "sort -t: -k1,1 -k2n" }
      printf "%5d of %4d lines  %s\n", lines[file] - missed, lines[file], file | "sort -k5"
      if (missed || !lines[file]) failed = 1
    }
    close("sort -t: -k1,1 -k2n")
    close("sort -k5")
    exit failed
  }' "$work/covered" "$work/constants" "$work/lcov"
