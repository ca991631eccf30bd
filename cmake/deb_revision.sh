#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# deb_revision.sh REV TREE PACKED: checks the revision REV out in the folder TREE, a worktree of its own that is made once, and
# makes its Debian packages there, TREE/build/deb, of its build PACKED (build/release, build/bench). Exit: 0, 64 usage, else make's.
set -euo pipefail

[ $# -eq 3 ] || { echo "deb_revision.sh REV TREE PACKED" >&2; exit 64; }
cd "$(dirname -- "${BASH_SOURCE[0]}")/.."
commit=$(git rev-parse --verify --quiet "$1^{commit}") || { echo "deb_revision.sh: no revision $1" >&2; exit 64; }
tree=$2

# `make clean` removes trees that git still lists.
git worktree prune
if [ -e "$tree/.git" ]; then
  git -C "$tree" checkout --quiet --detach "$commit"
else
  git worktree add --quiet --detach "$tree" "$commit"
fi
echo "deb_revision.sh: packages of ${commit:0:7}"
# That revision's Makefile has variables of its own.
env -u MAKEFLAGS -u MAKEOVERRIDES -u MAKELEVEL make --no-print-directory -C "$tree" deb PACKED="$3"
