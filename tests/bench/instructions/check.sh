#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check.sh PROGRAM [--write]: compares the instructions of three requests, a tick and a pump, counted by callgrind, with
# instructions.json: a deviation of more than 2 % in either direction is an error. --write: writes that file instead. Counts
# depend on compiler and C library; the check is skipped where they differ from those in the file.
# Exit: 0 equal, or skipped; 1 a deviation; 64 usage; 69 no callgrind.
set -euo pipefail

if [ $# -lt 1 ] || [ ! -x "$1" ]; then
  echo "check.sh PROGRAM [--write]" >&2
  exit 64
fi
program=$1
file=$(dirname -- "${BASH_SOURCE[0]}")/instructions.json
command -v valgrind >/dev/null || { echo "instructions: valgrind is not installed" >&2; exit 69; }

# A request or tick, and the number of repetitions counted.
counted=(ping:1000 device.status:500 effect.pulse:300 tick:1000 pump:1000)

# Compiler and library of the program's own build, if it has a build directory.
cache=$(dirname -- "$program")/../../CMakeCache.txt
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$cache" 2>/dev/null || true)
versions() {
  "${compiler:-c++}" --version | sed -n '1s/^[^ ]* */  "compiler": "g++ /; 1s/$/",/p'
  ldd --version | sed -n '1s/^[^ ]* */  "libc": "/; 1s/$/",/p'
}

# count WHAT TIMES: prints the instructions of one repetition, with an environment and string functions that all machines
# have.
count() {
  env -i PATH="$PATH" GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX,-AVX512F,-AVX512VL,-ERMS,-FSRM,-BMI2 \
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=hedgehog_counted "$program" "$1" "$2" 2>&1 |
    awk -v times="$2" '/Collected/ { found = $NF } END { if (found < times) exit 1; printf "%.0f\n", found / times }'
}

if [ "${2-}" != --write ]; then
  if ! diff <(grep -E '"(compiler|libc)"' "$file") <(versions) >&2; then
    echo "instructions: skipped, other compiler or C library than in ${file##*/}"
    exit 0
  fi
fi

failed=0
lines=()
for one in "${counted[@]}"; do
  what=${one%:*}
  now=$(count "$what" "${one#*:}") || { echo "instructions: $what cannot be counted" >&2; exit 1; }
  lines+=("    \"$what\": $now")
  [ "${2-}" != --write ] || continue
  written=$(sed -n "s/^ *\"$what\": \([0-9]*\),*$/\1/p" "$file")
  verdict=$(awk -v now="$now" -v written="${written:-0}" 'BEGIN {
    if (written == 0) { print "is not in the file: write it"; exit }
    off = 100 * (now / written - 1)
    printf "%+.1f %%", off
    if (off > 2) print ", MORE than 2 %: what costs it? If it is worth it, write it"
    else if (off < -2) print ", fewer by more than 2 %: write it, so that it stays"
  }')
  printf '%-14s %8d instructions, written %8d: %s\n' "$what" "$now" "${written:-0}" "$verdict"
  case $verdict in *"write it"*) failed=1 ;; esac
done

if [ "${2-}" = --write ]; then
  {
    echo '{'
    versions
    echo '  "instructions": {'
    (IFS=$'\n'; echo "${lines[*]}") | sed '$!s/$/,/'
    echo '  }'
    echo '}'
  } >"$file"
  cat "$file"
elif [ "$failed" -ne 0 ]; then
  echo "instructions: to write them: make instructions-write" >&2
fi
exit "$failed"
