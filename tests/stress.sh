#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# stress.sh [ROUNDS [FIRST]]: runs CI's tests, without linters, coverage and mutants, ROUNDS times (5) under the load of
# `stress-ng --cpu 4 --io 2`. Each round has one of the three parts (Makefile), as a day of CI has: the first round part FIRST (1), the
# next one the next. What the rounds need and takes long to build is built first, without that load. A round continues after a failed test
# and ends with its table (build/stress/<round>.json). It takes about an hour on 2 cores.
# Exit: 0 no round had a failure, 1 one had, 64 usage; else that of a build that failed.
set -u

rounds=${1:-5} first=${2:-1}
[[ $# -le 2 && $rounds =~ ^[1-9][0-9]*$ && $first =~ ^[123]$ ]] || { echo "stress.sh [ROUNDS [FIRST]]" >&2; exit 64; }
cd "$(dirname -- "${BASH_SOURCE[0]}")/.." || exit 70
out=$PWD/build/stress
mkdir -p "$out"

part_of() { echo $((($1 + first - 2) % 3 + 1)); } # ROUND
parts=$(for round in $(seq "$rounds"); do part_of "$round"; done)

build() { # PRESET TARGET...
  make "build/$1/build.ninja" && cmake --build --preset "$1" --target "${@:2}"
}
build dev all || exit
[[ $parts != *1* ]] || build asan all fuzzers || exit
[[ $parts != *3* ]] || build tsan threaded || exit
build dev test_usb cpp_conformance cpp_racer cpp_session slow_names json_readers || exit
make shipped dashboard racer-page || exit

stress-ng --cpu 4 --io 2 --temp-path "$out" --quiet &
load=$!
trap 'kill "$load"; wait "$load"' EXIT
trap 'exit 130' INT TERM

failed=0
for round in $(seq "$rounds"); do
  PARTS=$(part_of "$round")
  export PARTS
  export HEDGEHOG_STAGES=$out/$round.tsv
  : >"$HEDGEHOG_STAGES"
  SECONDS=0
  make test >"$out/$round.log" 2>&1 || failed=1
  tests/side_by_side.sh waiting-and-beside computing-tests >>"$out/$round.log" 2>&1 || failed=1
  printf 'whole\t%d\n' "$SECONDS" >>"$HEDGEHOG_STAGES"
  echo "round $round of $rounds, part $PARTS"
  cmake/stage_table.sh "$HEDGEHOG_STAGES" "$out/$round.json"
done
exit "$failed"
