#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# compare.sh REV [OPTION...]: measures this tree's build (preset bench) and that of another revision in the same rounds.
# The revision is checked out and built below build/compare; the options are those of tests/bench/load.
set -euo pipefail

[ $# -ge 1 ] || { echo "compare.sh REV [OPTION...]" >&2; exit 64; }
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."
commit=$(git rev-parse --verify --quiet "$1^{commit}") || { echo "compare: no revision $1" >&2; exit 64; }
shift
revision=${commit:0:10}
tree=$PWD/build/compare/$revision

# `make clean` removes trees that git still lists.
git worktree prune
[ -e "$tree/.git" ] || git worktree add --detach "$tree" "$commit" >/dev/null
log=$tree/build/compare.log
mkdir -p "$tree/build"
echo "compare: building $revision" >&2
build() {
  (cd "$tree" && cmake --preset bench && cmake --build --preset bench --target hedgehogd) >"$log" 2>&1 || return 1
  # Programs that older revisions do not have.
  (cd "$tree" && cmake --build --preset bench --target plant_hour client_cost) >>"$log" 2>&1 || true
}
build || { tail -n 20 "$log" >&2; exit 1; }
build/bench/tests/bench/rounds --other "$tree/build/bench" --revision "$revision" --out build/bench-compare.json "$@"
