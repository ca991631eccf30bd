#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh: tests cmake/release.sh in a clone of the last commit. Exit: 0 all passed.
set -euo pipefail

source=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
git -C "$source" rev-parse --verify --quiet HEAD >/dev/null || { echo "tests/release: left out: no git repository"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "tests/release: $*" >&2; exit 1; }
step() { echo "tests/release: $*"; }
export GIT_AUTHOR_NAME=tester GIT_AUTHOR_EMAIL=tester@localhost GIT_COMMITTER_NAME=tester GIT_COMMITTER_EMAIL=tester@localhost
git clone --quiet --no-tags "$source" "$work/clone"
cd "$work/clone"
git checkout --quiet -B release
begin=$(git rev-parse HEAD)
# refused SENTENCE COMMAND...: the command must exit with 65, print SENTENCE and change nothing.
refused() {
  local sentence=$1 code=0
  shift
  "$@" 2>"$work/refusal" || code=$?
  [ "$code" = 65 ] || fail "exit $code, not 65: $*"
  grep -q "$sentence" "$work/refusal" || fail "$(cat "$work/refusal") does not say: $sentence"
  [ "$(git rev-parse HEAD)" = "$begin" ] || fail "it has committed: $sentence"
}

# has_version VERSION: in all files of the tree that name it.
has_version() {
  local file line
  while IFS='|' read -r file line; do
    grep -qF -- "$line" "$file" || fail "$file has no '$line'"
  done <<LINES
CITATION.cff|version: $1
CMakeLists.txt|project(hedgehog VERSION $1 LANGUAGES
clients/godot/addons/hedgehog/plugin.cfg|version="$1"
clients/js/README.md|/hedgehog-client-$1.tgz
clients/js/package.json|  "version": "$1"
clients/python/hedgehog/__init__.py|__version__ = "$1"
clients/python/pyproject.toml|version = "$1"
clients/unity/package.json|  "version": "$1"
clients/unreal/HedgehogHaptics.uplugin|  "VersionName": "$1"
LINES
}

step "one version"
before=$(sed -nE 's/^project\(hedgehog VERSION ([0-9.]+) .*/\1/p' CMakeLists.txt)
has_version "$before"

step "refused"
code=0
cmake/release.sh 1.2 2>"$work/refusal" || code=$?
[ "$code" = 64 ] || fail "1.2 is taken as a version"
touch unknown
refused "not committed" cmake/release.sh 98.0.0
rm unknown
refused "not above $before" cmake/release.sh 0.0.1
refused "not above $before" cmake/release.sh "$before"
git tag v98.0.0
refused "there already" cmake/release.sh 98.0.0
refused "not above v98.0.0" cmake/release.sh 97.0.0
git checkout --quiet --detach
refused "no branch" cmake/release.sh 99.0.0
git checkout --quiet release
sed -i 's/^## \[Unreleased\]$/&\n\n## [98.0.0]/' CHANGELOG.md
git commit --quiet --all --message empty
begin=$(git rev-parse HEAD)
refused "nothing under" cmake/release.sh 99.0.0
git reset --quiet --hard HEAD~1

step "released"
cmake/release.sh 99.0.0 "$work/out" >/dev/null
[ "$(git describe --exact-match)" = v99.0.0 ] || fail "the tag is not there, or not annotated"
[ -z "$(git status --porcelain)" ] || fail "changes are left"
[ "$(dpkg-parsechangelog --show-field Version)" = 99.0.0 ] || fail "debian/changelog"
has_version 99.0.0
[ "$(grep -A 2 '^## \[Unreleased\]$' CHANGELOG.md | sed -n 3p | cut -c -11)" = '## [99.0.0]' ] || fail "CHANGELOG.md"
(cd "$work/out" && sha256sum --check --quiet SHA256SUMS)
mkdir "$work/unpacked"
tar -xzf "$work/out/hedgehog-99.0.0.tar.gz" -C "$work/unpacked"
git archive v99.0.0 | tar -x -C "$work/unpacked" --one-top-level=archive
diff -r "$work/unpacked/hedgehog-99.0.0" "$work/unpacked/archive" || fail "the tarball is not the tag's tree"

step "bill of materials"
python3 "$source/tests/release/check_sbom.py" "$work/out/hedgehog-99.0.0.spdx.json" "$source"
step "all is well"
