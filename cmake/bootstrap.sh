#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the packages of the named lists (cmake/apt/<list>.txt; default: build test) that are missing.
# Uses neither apt nor root when none is missing. Exit: 0 all installed, 64 usage, 69 cannot be installed.
set -eu

lists=$(dirname -- "$0")/apt

say() { printf '%s\n' "$*" >&2; }

# "libboost-dev>=1.81" -> name and minimum version; empty: any version.
name_of() { printf '%s\n' "${1%%>=*}"; }
least_of() { case $1 in *'>='*) printf '%s\n' "${1#*>=}" ;; *) printf '\n' ;; esac; }

new_enough() { # version least
  [ -z "$2" ] || dpkg --compare-versions "$1" ge "$2"
}

installed_version() {
  # shellcheck disable=SC2016  # the format is dpkg-query's, not the shell's
  dpkg-query -W -f='${db:Status-Status} ${Version}\n' "$1" 2>/dev/null |
    sed -n 's/^installed //p' | head -n 1
}

candidate_version() {
  LC_ALL=C apt-cache policy "$1" 2>/dev/null | sed -n 's/^  Candidate: //p' | grep -v '^(none)$' || true
}

# first_of installed|candidate WANT...: the first alternative that is installed, or that apt could install.
first_of() {
  where=$1
  shift
  for want in "$@"; do
    name=$(name_of "$want")
    version=$("${where}_version" "$name")
    if [ -n "$version" ] && new_enough "$version" "$(least_of "$want")"; then
      printf '%s\n' "$name"
      return 0
    fi
  done
  return 1
}

wanted_lines() {
  for list in "$@"; do
    [ -f "$lists/$list.txt" ] || { say "bootstrap: no list $list"; exit 64; }
    sed -e 's/#.*//' -e 's/|/ /g' -e '/^[[:space:]]*$/d' "$lists/$list.txt"
  done
}

missing_lines() {
  while read -r line; do
    # shellcheck disable=SC2086  # the words of a line are the alternatives
    first_of installed $line >/dev/null || printf '%s\n' "$line"
  done
}

packages_for() {
  while read -r line; do
    # shellcheck disable=SC2086
    first_of candidate $line || name_of "${line%% *}"
  done
}

[ $# -gt 0 ] || set -- build test
wanted=$(wanted_lines "$@")

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  say "bootstrap: this is no Debian or Ubuntu. Install the equivalents of:"
  say "$wanted"
  say "then build with cmake --preset release && cmake --build --preset release"
  exit 69
fi

missing=$(printf '%s\n' "$wanted" | missing_lines)
[ -n "$missing" ] || exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    say "bootstrap: packages are missing and this is neither root nor is there sudo. As root, run:"
    say "apt-get update && apt-get install -y --no-install-recommends" \
      "$(printf '%s\n' "$missing" | packages_for | tr '\n' ' ')"
    exit 69
  fi
  as_root=sudo
  [ -t 0 ] || as_root='sudo -n'
fi

root_apt() {
  # shellcheck disable=SC2086  # "sudo -n" is two words, nothing is none
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -o Acquire::Retries=3 "$@"
}

root_apt update || say "bootstrap: apt-get update failed, trying with what apt already knows"
packages=$(printf '%s\n' "$missing" | packages_for | tr '\n' ' ')
say "bootstrap: installing $packages"
# shellcheck disable=SC2086
if ! root_apt install -y --no-install-recommends --no-remove $packages; then
  say "bootstrap: apt could not do it without removing something or without its servers. By hand, run:"
  say "apt-get update && apt-get install --no-install-recommends $packages"
  exit 69
fi
