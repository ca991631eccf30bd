#!/bin/sh
# SPDX-License-Identifier: MIT
# Format, lint and shell checks over the whole tree. Findings are printed.
# check.sh [format|shell|tidy|alone|tidy-product|alone-third]...; default the first four. tidy-product excludes the tests;
# alone-third too, and checks one in three of the other files: a different third every three days.
# Exit: 0 clean, 1 not.
# JOBS: how many linters at once.
set -u

cd "$(dirname -- "$0")/.." || exit 1
jobs=${JOBS:-2}
failed=0

sources() {
  find base cli model protocol access daemon emulator clients firmware tests cmake -name '*.cpp' -o -name '*.h' | sort
}

check_format() {
  sources | xargs clang-format --dry-run -Werror ||
    { echo "check: run clang-format -i on the files above"; failed=1; }
}

check_shell() {
  # All files that begin with the interpreter line of a shell.
  find . -path ./build -prune -o -path ./.git -prune -o -type f -size -200k -print |
    xargs grep -lE -m1 '^#!.*(/| )(ba)?sh$' | xargs shellcheck || failed=1
}

# configure PRESET: writes the commands that would compile the tree.
configure() {
  mkdir -p build
  cmake --preset "$1" >"build/$1.log" 2>&1 || { cat "build/$1.log"; exit 1; }
}

# files PRESET [WITHOUT]: the sources that a preset compiles, except those that match WITHOUT.
files() {
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "build/$1/compile_commands.json" | grep -v "${2:-^$}" | sort -u
}

# In batches, which is three times as fast. Headers are checked with the sources that include them. A linter's findings are
# printed on stdout, all at once, only if there are any; its counts go to stderr.
check_tidy() { # [WITHOUT]
  configure tidy
  # shellcheck disable=SC2016
  files tidy "${1-}" | xargs -n 1 -P "$jobs" sh -c \
    'found=$(clang-tidy -p build/tidy --quiet "$1" 2>/dev/null) || { printf "%s\n" "$found"; exit 1; }' tidy || failed=1
}

# Compiles each file separately, without batches and precompiled headers, with the compiler of the shipped programs: detects
# missing includes.
check_alone() {
  configure alone
  # A command a line; JSON escapes quotes.
  sed -n 's/^ *"command": "\(.*\)",$/\1/p' build/alone/compile_commands.json | "$@" |
    sed 's/\\"/"/g; s/\\\\/\\/g; s/ -o [^ ]*\.o / -fsyntax-only /' | tr '\n' '\0' | (cd build/alone && xargs -0 -n 1 -P "$jobs" sh -c) ||
    failed=1
}

# shellcheck disable=SC2317  # called by check_alone
third() {
  grep -v ' [^ ]*/tests/[^ ]*$' | awk -v turn="$(($(date +%s) / 86400 / 3))" '(NR + turn) % 3 == 0'
}

[ $# -gt 0 ] || set -- format shell tidy alone
for check in "$@"; do
  echo "check: $check"
  case $check in
    format) check_format ;;
    shell) check_shell ;;
    tidy) check_tidy ;;
    alone) check_alone cat ;;
    alone-third) check_alone third ;;
    tidy-product) check_tidy /tests/ ;;
    *) echo "check.sh [format|shell|tidy|alone|tidy-product|alone-third]..." >&2; exit 64 ;;
  esac
done
exit "$failed"
