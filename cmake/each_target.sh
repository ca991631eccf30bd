#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# each_target.sh TARGETS...: makes one after another; one that fails keeps none of the others from being tried. An argument may
# have several words: 'test-deb PACKED=build/bench'.
# With HEDGEHOG_DEADLINE (seconds since 1970) none begins after it. With HEDGEHOG_STAGES=FILE those that were skipped and those
# that failed are named in that file, and the last lines of those that failed are kept beside it, in FILE.failed.
# Exit: 0 all were made or skipped, 1 one failed.
set -uo pipefail

[ $# -ge 1 ] || { echo "each_target.sh TARGETS..." >&2; exit 64; }
stages=${HEDGEHOG_STAGES-}
late() { [ -n "${HEDGEHOG_DEADLINE-}" ] && [ "$(date +%s)" -ge "$HEDGEHOG_DEADLINE" ]; }
record() { [ -z "$stages" ] || printf '%s\t%s\n' "$1" "$2" >>"$stages"; }

code=0
for target in "$@"; do
  if late; then
    echo "not begun for want of time: $target" >&2
    record late "$target"
    continue
  fi
  read -ra words <<<"$target"
  if [ -z "$stages" ]; then
    "${MAKE:-make}" "${words[@]}" || code=1
    continue
  fi
  log=$(mktemp)
  exec {output}> >(exec tee "$log")
  copier=$!
  result=0
  "${MAKE:-make}" "${words[@]}" >&"$output" 2>&1 {output}>&- || result=1
  exec {output}>&-
  # Not for ever: what a test leaves running keeps the output open.
  timeout 5 tail --pid="$copier" -f /dev/null || true
  if [ "$result" -ne 0 ]; then
    code=1
    record red "$target"
    { printf '\n%s, its last lines:\n' "$target"; tail -n 40 "$log"; } >>"$stages.failed"
  fi
  rm -f "$log"
done
exit "$code"
