#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: a rehearsed study, exported by that build's hedgehog-study, before the validator of the Brain Imaging Data
# Structure. Exit: 0 it has neither an error nor a warning, 1 it has.
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
build=$(cd -- "${1:?run.sh BUILD}" && pwd)
packages=$root/build/npm/bids
study=$build/clients/study/hedgehog-study

"$root/cmake/npm.sh" "$here" "$packages"
home=$(mktemp -d)
daemon=
clean() {
  if [ -n "$daemon" ]; then
    kill "$daemon" 2>/dev/null || true
    wait "$daemon" || true
  fi
  rm -rf "$home"
}
trap clean EXIT

mkdir -p "$home/config/hedgehog" "$home/run"
echo '{"http": {"listen": "127.0.0.1:0"}}' >"$home/config/hedgehog/hedgehogd.json"
# A busy machine is no reason to give up.
export HEDGEHOG_PATIENCE_MS=60000
export XDG_CONFIG_HOME=$home/config XDG_STATE_HOME=$home/state XDG_RUNTIME_DIR=$home/run
"$build/daemon/hedgehogd" --simulate --speed 100 --listen 127.0.0.1:0 --log-level error >"$home/out" &
daemon=$!
until grep -q 'listening on /' "$home/out"; do
  kill -0 "$daemon" || exit 1
  sleep 0.05
done
HEDGEHOG_ADDRESS=$(sed -n 's|.*listening on \(/.*\)|\1|p' "$home/out" | head -n 1)
export HEDGEHOG_ADDRESS

# One and two presentations, with catch trials, practice and short circles.
cat >"$home/quick.json" <<'JSON'
{"name": "quick", "task": "two_intervals", "level": "current_percent", "question": "Which one was stronger?",
 "start": 100, "ceiling": 200, "stages": [{"step_up": 20, "reversals": 4}], "step_ratio": 0.5488,
 "duration_ms": 300, "gap_ms": 200, "practice": 1}
JSON
cat >"$home/quick-yes-no.json" <<'JSON'
{"name": "quick-yes-no", "task": "yes_no", "level": "current_a", "question": "Felt it?", "start": 5, "ceiling": 15,
 "stages": [{"step_up": 1, "reversals": 4}], "step_ratio": 0.5488, "duration_ms": 300, "practice": 0, "catch_one_in": 4}
JSON
cd "$home"
"$study" plan th --participants 2 --experiments quick.json,quick-yes-no.json >/dev/null
"$study" -C th rehearse
"$study" -C th exclude P01 quick --reason 'a door slammed'
"$study" -C th export --format bids
NODE_NO_WARNINGS=1 node "$packages/node_modules/bids-validator/bin/bids-validator" th/bids --json >report.json || true
node "$here/print_issues.mjs" report.json
