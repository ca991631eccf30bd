#!/bin/sh
# SPDX-License-Identifier: MIT
# Format, lint and shell checks over the whole tree. Needs `cmake --preset tidy` to have run. Exit: 0 clean, 1 not.
# check.sh [format|shell|tidy|tidy-product]...; default the first three; tidy-product leaves the tests out.
# JOBS: how many linters at once.
set -u

cd "$(dirname -- "$0")/.." || exit 1
jobs=${JOBS:-2}
failed=0

sources() {
  find model protocol daemon clients tests cmake -name '*.cpp' -o -name '*.h' | sort
}

check_format() {
  sources | xargs clang-format --dry-run -Werror ||
    { echo "check: run clang-format -i on the files above"; failed=1; }
}

check_shell() {
  # Whatever begins with a shell's name, wherever it lives.
  find . -path ./build -prune -o -path ./.git -prune -o -type f -size -200k -print |
    xargs grep -lE -m1 '^#!.*(/| )(ba)?sh$' | xargs shellcheck || failed=1
}

# What is built here, each file by itself, without batches and precompiled headers: a missing include is found too.
# Headers are judged with whoever includes them. A linter prints its findings on stdout, all at once, only when it has
# any; its counts go to stderr.
check_tidy() {
  # shellcheck disable=SC2016
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/tidy/compile_commands.json | grep -v "/build/\|${1:-^$}" | sort -u |
    xargs -n 1 -P "$jobs" sh -c \
    'found=$(clang-tidy -p build/tidy --quiet "$1" 2>/dev/null) || { printf "%s\n" "$found"; exit 1; }' tidy || failed=1
}

[ $# -gt 0 ] || set -- format shell tidy
for check in "$@"; do
  echo "check: $check"
  case $check in
    format) check_format ;;
    shell) check_shell ;;
    tidy) check_tidy ;;
    tidy-product) check_tidy /tests/ ;;
    *) echo "check.sh [format|shell|tidy|tidy-product]..." >&2; exit 64 ;;
  esac
done
exit "$failed"
