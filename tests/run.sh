#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh PRESET [tests | programs]: runs the tests of a build, in passes: those on virtual time, then those with the label
# `clock`, which run real programs and threads on the real clock. Only a `clock` test that fails is run once more.
# The programs of a sanitizer, and of `bench`, are run by the end-to-end tests of `dev`, which are all `clock`.
# JOBS: cores to use. Exit: 0 all passed, else ctest's.
set -u

case $#,${2-} in
  1, | 2,tests | 2,programs) ;;
  *) echo "run.sh PRESET [tests | programs]" >&2; exit 64 ;;
esac
preset=$1 what=${2-}
cd "$(dirname -- "$0")/.." || exit 70
results=$PWD/build/$preset/results
mkdir -p "$results"
jobs=${JOBS:-2}

failed=0
# pass NAME TEST-PRESET CTEST-OPTION...
pass() {
  local name=$1 code
  # The end of a process's output contains the number of its tests.
  cmake/stage.sh "tests $preset $name" ctest --preset "$2" --test-output-truncation head \
    --output-junit "$results/$name.xml" "${@:3}" | tee "$results/$name.log"
  code=${PIPESTATUS[0]}
  [ -z "${HEDGEHOG_STAGES-}" ] || record "$name" >>"$HEDGEHOG_STAGES"
  [ "$code" -eq 0 ] || failed=$code
}
# Tests with the label `clock` wait most of the time.
clock=(--repeat until-pass:2 -j "$((4 * jobs))")

# For the table of stages: the number of tests, the time of each program, and the repeated tests.
record() { # NAME
  awk -v preset="$preset" '
    function attribute(name,   at) {
      return match($0, " " name "=\"[^\"]*\"") ? substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 4) : ""
    }
    # One attribute a line, before the first test.
    split($0, part, "\"") == 3 && part[1] ~ /^\t(tests|failures|skipped)=$/ { total[substr(part[1], 2)] = part[2] }
    /<testcase/ {
      program = attribute("name")
      sub(/\..*/, "", program)
      time[program] += attribute("time")
      count[program]++
      in_shard = attribute("name") ~ /\.shard[0-9]+$/
    }
    # Output of a process that ran several tests: "[==========] 66 tests from 9 test suites ran. (12 ms total)".
    in_shard && match($0, /\[==========\] [0-9]+ tests? from .* ran\./) {
      split(substr($0, RSTART), part, " ")
      count[program] += part[2] - 1
      total["tests="] += part[2] - 1
      in_shard = 0
    }
    END {
      for (program in time) {
        printf "program\t%s test_%s\t%.1f\t%d\n", preset, program, time[program], count[program] | "sort"
      }
      close("sort")
      printf "tests\t%d\t%d\t%d\n", total["tests="], total["failures="], total["skipped="]
    }' "$results/$1.xml"
  # ctest prints the name of a test once for each of its runs.
  sed -nE 's/^ *([0-9]+\/[0-9]+ )?Test +#[0-9]+: ([^ ]+) .*(Passed|\*\*\*).*/\2/p' "$results/$1.log" | sort | uniq -d |
    sed "s/^/repeated\t$preset /"
}

tests() {
  # Processor time of one process: a busy machine does not change it. Under a sanitizer tests take several times as long.
  local limit_s=240
  case $preset in asan | tsan) limit_s=900 ;; esac
  ulimit -S -t "$limit_s"
  pass virtual "$preset" --label-exclude '^(clock|fuzz)$' -j "$jobs"
  ulimit -S -t hard
  pass clock "$preset" --label-regex '^clock$' "${clock[@]}"
}
programs() { pass programs "$preset-programs" "${clock[@]}"; }

case $what,$preset in
  programs,* | ,bench) programs ;;
  ,asan | ,tsan) tests; programs ;;
  *) tests ;;
esac
exit "$failed"
