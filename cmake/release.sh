#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# release.sh VERSION [OUT]: makes the release VERSION ("1.2.0") of the clean branch that is checked out.
#   CHANGELOG.md's [Unreleased], which must not be empty, becomes [VERSION] of today; CMakeLists.txt, CITATION.cff,
#   debian/changelog and the client libraries get the version; that is committed and tagged vVERSION (annotated). In OUT
#   (build/release-VERSION):
#   hedgehog-VERSION.tar.gz (git archive), hedgehog-VERSION.spdx.json (sbom.py), SHA256SUMS.
# Pushes nothing: git push --follow-tags does. To undo: git tag -d vVERSION; git reset --hard HEAD~1.
# Exit: 0 done, 64 usage, 65 the tree is not ready to be released (nothing has been changed then), 69 see sbom.py.
set -euo pipefail

fail() { echo "release.sh: $*" >&2; exit 65; }

if [ $# -lt 1 ] || [ $# -gt 2 ] || [[ ! $1 =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]]; then
  echo "release.sh VERSION [OUT], VERSION as 1.2.0" >&2
  exit 64
fi
version=$1
cd "$(dirname -- "${BASH_SOURCE[0]}")/.."
out=${2:-build/release-$version}

[ -z "$(git status --porcelain)" ] || fail "there are changes that are not committed"
git symbolic-ref --quiet HEAD >/dev/null || fail "no branch is checked out"
! git rev-parse --quiet --verify "refs/tags/v$version" >/dev/null || fail "v$version is there already"
before=$(sed -nE 's/^project\(hedgehog VERSION ([0-9.]+) .*/\1/p' CMakeLists.txt)
newest=$(git tag --list 'v[0-9]*' --sort=-version:refname | head -n 1)
{ [ -z "$newest" ] || dpkg --compare-versions "$version" gt "${newest#v}"; } || fail "$version is not above $newest"
# Packages of commits are $before+git..., so a release of $before itself would be older than they are.
dpkg --compare-versions "$version" gt "$before" || fail "$version is not above $before of CMakeLists.txt"
grep -q "^## \[Unreleased\]$" CHANGELOG.md || fail "CHANGELOG.md has no [Unreleased]"
! grep -qF "## [$version]" CHANGELOG.md || fail "CHANGELOG.md has [$version] already"
notes=$(awk '/^## / { on = $0 == "## [Unreleased]"; next } on' CHANGELOG.md)
grep -q '^- ' <<<"$notes" || fail "CHANGELOG.md has nothing under [Unreleased]"

# Checks that the bill of materials can be made before anything is changed.
python3 cmake/sbom.py "$version" none 1970-01-01T00:00:00Z >/dev/null

day=$(date -u +%F)
sed -i "s/^## \[Unreleased\]$/## [Unreleased]\n\n## [$version] - $day/" CHANGELOG.md
sed -i -E "s/^(project\(hedgehog VERSION )[0-9.]+/\1$version/" CMakeLists.txt
sed -i -E "s/^version: .*/version: $version/" CITATION.cff
# Wheel, npm's file and plugins are named after it: others of the same name would have other contents.
sed -i -E "s/^((__)?version(__)? ?= ?)\"[0-9.]+\"/\1\"$version\"/" \
  clients/python/pyproject.toml clients/python/hedgehog/__init__.py clients/godot/addons/hedgehog/plugin.cfg
sed -i -E "s/^(  \"(version|VersionName)\": )\"[0-9.]+\"/\1\"$version\"/" \
  clients/js/package.json clients/unity/package.json clients/unreal/HedgehogHaptics.uplugin
sed -i -E "s/hedgehog-client-[0-9.]+\.tgz/hedgehog-client-$version.tgz/" clients/js/README.md
if [ "$(dpkg-parsechangelog --show-field Version)" != "$version" ]; then
  {
    printf 'hedgehog (%s) unstable; urgency=medium\n\n  * Release %s; its changes are in CHANGELOG.md.\n\n' "$version" "$version"
    printf ' -- %s  %s\n\n' "$(dpkg-parsechangelog --show-field Maintainer)" "$(date -u -R)"
    cat debian/changelog
  } >debian/changelog.new
  mv debian/changelog.new debian/changelog
fi
git commit --quiet --all --message "Release $version"
git tag --annotate --message "Hedgehog $version" "v$version"

mkdir -p "$out"
name=hedgehog-$version
git archive --format=tar --prefix="$name/" "v$version" | gzip -9 --no-name >"$out/$name.tar.gz"
date=$(TZ=UTC git log -1 --format=%cd --date=format-local:%Y-%m-%dT%H:%M:%SZ)
python3 cmake/sbom.py "$version" "$(git rev-parse HEAD)" "$date" >"$out/$name.spdx.json"
(cd "$out" && sha256sum "$name.tar.gz" "$name.spdx.json" >SHA256SUMS)
echo "release.sh: v$version is committed and tagged; $out has the tarball, its bill of materials and their sums"
