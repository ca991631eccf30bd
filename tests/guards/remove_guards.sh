#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Removes each guard of guards.txt, one at a time, and requires a failing test. Needs `make dev`: only the changed file is
# compiled, and linked into the test programs of that build.
# remove_guards.sh [--third] [WORD]: only guards whose name or hazard contains WORD; with --third every third one, selected
# by the day of the month. JOBS: guards at a time. Exit: 0 each had a failing test, 1 one had none or could not be
# checked, 64 usage or no such guard, 65 a guard is not in the file that guards.txt names.
set -euo pipefail

third=''
if [ "${1-}" = --third ]; then
  day=$(date +%d)
  third=$((10#$day % 3))
  shift
fi
[ $# -le 1 ] || { echo "remove_guards.sh [--third] [WORD]" >&2; exit 64; }
word=${1:-}
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."
work=build/guards
rm -rf "$work"
mkdir -p "$work"

# exchange FILE CUT PUT: replaces the only occurrence of CUT, literally; "\n" in both is an end of line.
exchange() {
  CUT=${2//\\n/$'\n'} PUT=${3//\\n/$'\n'} awk '
    { text = text $0 "\n" }
    END {
      cut = ENVIRON["CUT"]; at = index(text, cut)
      rest = substr(text, at + length(cut))
      if (at == 0 || index(rest, cut) != 0) exit 65
      printf "%s%s%s", substr(text, 1, at - 1), ENVIRON["PUT"], rest
    }' "$1" >"$1.new" || return 65
  mv "$1.new" "$1"
}

# A folder for each guard: its changed files in source/; the other files are the input of test_guard.sh.
hazard='' guard='' file='' cut='' number=0 folder=''
begin() { # guard
  guard=$1
  number=$((number + 1))
  folder=$work/$number
  mkdir -p "$folder"
  printf '%s\n' "$hazard" >"$folder/hazard"
  printf '%s\n' "$guard" >"$folder/guard"
  if [[ "$hazard $guard" == *"$word"* ]] && [[ -z $third || $((number % 3)) -eq $third ]]; then
    touch "$folder/selected"
  fi
}
change() { # put
  local copy=$folder/source/$file
  if [ ! -e "$copy" ]; then
    mkdir -p "${copy%/*}"
    cp "$file" "$copy"
    printf '%s\n' "$file" >>"$folder/files"
  fi
  exchange "$copy" "$cut" "$1" || { echo "guards: $file does not have once: $cut" >&2; exit 65; }
}
while IFS= read -r line; do
  case $line in
    '#'* | '') ;;
    'hazard '*) hazard=${line#hazard } ;;
    'guard '*) begin "${line#guard }" ;;
    'file '*) file=${line#file } ;;
    'cut '*) cut=${line#cut } ;;
    put*)
      put=${line#put}
      change "${put# }"
      ;;
    'red '*) printf '%s\n' "${line#red }" >>"$folder/red" ;;
    *) echo "guards.txt: $line" >&2; exit 65 ;;
  esac
done <tests/guards/guards.txt

# shellcheck source=tests/relink.sh
. tests/relink.sh
list_commands "$work/commands"
guards_with() { find "$work" -name "$1" -printf '%h\n' | sort -t/ -k3 -n; }
guards_with selected | xargs -r -P "${JOBS:-2}" -n 1 tests/guards/test_guard.sh || true
wanted=$(guards_with selected | wc -l)
[ "$wanted" -gt 0 ] || { echo "guards: none has $word" >&2; exit 64; }
red=$(guards_with seen_red | wc -l)
echo "$red of $wanted guards seen red without them (the list has $number)"
[ "$red" -eq "$wanted" ]
