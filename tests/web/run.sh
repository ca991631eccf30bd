#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD [shots FOLDER]: tests the pages of that build in a browser, or takes screenshots. BUILD has the programs and,
# in share/hedgehog/www and share/hedgehog/racer, the pages.
# A browser and real programs on the real clock, like tests with the label `clock` (tests/run.sh): failed tests are run
# once more, alone, and named in the table of stages. Exit: 0 all passed, at once or the second time.
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
build=$(cd -- "${1:?run.sh BUILD}" && pwd)
packages=$root/build/npm/web

"$root/cmake/npm.sh" "$here" "$packages"
HEDGEHOGD=$build/daemon/hedgehogd
HEDGEHOGCTL=$build/clients/ctl/hedgehogctl
HEDGEHOG_RACER=$build/clients/racer/hedgehog-racer
HEDGEHOG_STUDY=$build/clients/study/hedgehog-study
HEDGEHOG_DESIGN=$build/clients/design/hedgehog-design
HEDGEHOG_NODE_MODULES=$packages/node_modules
export HEDGEHOGD HEDGEHOGCTL HEDGEHOG_RACER HEDGEHOG_STUDY HEDGEHOG_DESIGN HEDGEHOG_NODE_MODULES
if [ "${2-}" = shots ]; then
  exec node "$here/shots.mjs" "${3:?run.sh BUILD shots FOLDER}"
fi
run=("$root/tests/node_test.sh" 480000 --test-concurrency=1 --test-reporter=tap)

log=$(mktemp)
trap 'rm -f "$log"' EXIT
result=0
"${run[@]}" "$here"/*.test.mjs | tee "$log" || result=$?
[ "$result" -ne 0 ] || exit 0

# A file that cannot be loaded is a failed test, too, but no test name selects it.
mapfile -t failed < <(sed -nE 's/^not ok [0-9]+ - //p' "$log")
[ "${#failed[@]}" -gt 0 ] || exit "$result"
again=()
for name in "${failed[@]}"; do
  [[ $name != *.mjs ]] || exit "$result"
  [ -z "${HEDGEHOG_STAGES-}" ] || printf 'repeated\tweb %s\n' "$name" >>"$HEDGEHOG_STAGES"
  echo "run once more: $name"
  # Escapes the name for the regular expression.
  again+=(--test-name-pattern="^$(sed 's/[][(){}\\.*^?+|/$]/\\&/g' <<<"$name")\$")
done
"${run[@]}" "${again[@]}" "$here"/*.test.mjs
