#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Takes each guard of guards.txt out, one at a time, in a copy of the tree, and asks for a red test.
# remove_guards.sh [--third] [WORD]: only guards whose name or hazard has WORD; with --third every third one, which ones
# by the day of the month. Exit: 0 all seen red, 1 one survived, 64 usage, 65 a guard is not where guards.txt says.
set -euo pipefail

third=''
if [ "${1-}" = --third ]; then
  day=$(date +%d)
  third=$((10#$day % 3))
  shift
fi
[ $# -le 1 ] || { echo "remove_guards.sh [--third] [WORD]" >&2; exit 64; }
word=${1:-}
top=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$top"
copy=build/guards/source
build=build/guards/build
targets=(test_model test_safety test_control test_device)

rm -rf "$copy"
mkdir -p "$copy"
git ls-files -z | xargs -0 cp --parents -t "$copy"
echo "guards: building the tests once"
# Without warnings: a guard that is gone leaves variables unused. In batches, but for what is going to be changed.
guarded=$(sed -n 's/^file \(.*\.cpp\)$/\1/p' tests/guards/guards.txt | sort -u | paste -sd ';')
cmake -S "$copy" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS=-w -DHEDGEHOG_UNITY=ON \
  -DHEDGEHOG_UNITY_EXCEPT="$guarded" >"$build.log"
compile() { # targets
  cmake --build "$build" --target "$@" >"$build.log" 2>&1
}
compile "${targets[@]}" || { tail -n 20 "$build.log"; exit 1; }

# exchange FILE CUT PUT: literally, once; "\n" in both is a line's end.
exchange() {
  CUT=${2//\\n/$'\n'} PUT=${3//\\n/$'\n'} awk '
    { text = text $0 "\n" }
    END {
      cut = ENVIRON["CUT"]; at = index(text, cut)
      rest = substr(text, at + length(cut))
      if (at == 0 || index(rest, cut) != 0) exit 65
      printf "%s%s%s", substr(text, 1, at - 1), ENVIRON["PUT"], rest
    }' "$copy/$1" >"$copy/$1.new" || return 65
  mv "$copy/$1.new" "$copy/$1"
}

hazard='' guard='' file='' cut=''
files=() red=()
number=0 seen=0 survived=0

# The names of the failed tests of one program.
failures_of() { # program filter
  local out status=0
  out=$(timeout 300 "$build/tests/test_$1" --gtest_filter="$2" --gtest_brief=1 2>&1) || status=$?
  [ "$status" -ne 0 ] || return 0
  printf '%s\n' "$out" | sed -nE 's/^\[  FAILED  \] ([^ ,]+).* \([0-9]+ ms\)$/\1/p' | sort -u | grep . ||
    echo "test_$1 ended with $status"
}

judge() {
  [ -n "$guard" ] || return 0
  number=$((number + 1))
  if [[ -z $word || "$hazard $guard" == *"$word"* ]] && [[ -z $third || $((number % 3)) -eq $third ]]; then
    local found='' blind='' names one programs=("${red[@]%% *}")
    compile "${programs[@]/#/test_}" || { echo "guards: without it this does not compile: $guard"; tail -n 20 "$build.log"; exit 65; }
    for one in "${red[@]}"; do
      names=$(failures_of "${one%% *}" "${one#* }")
      [ -n "$names" ] || blind+=" $one;"
      found+=$names$'\n'
    done
    found=$(printf '%s' "$found" | grep . || true)
    seen=$((seen + 1))
    if [ -n "$blind" ]; then
      survived=$((survived + 1))
      printf 'SURVIVED  %-34.34s %s:%s\n' "$hazard" "$guard" "$blind"
    else
      printf 'red %4d  %-34.34s %s: %s\n' "$(printf '%s\n' "$found" | wc -l)" "$hazard" "$guard" \
        "$(printf '%s\n' "$found" | head -n 2 | paste -sd ' ')"
    fi
  fi
  for one in "${files[@]}"; do cp "$one" "$copy/$one"; done
  guard='' files=() red=()
}

while IFS= read -r line || [ -n "$line" ]; do
  case $line in
    '#'*) ;;
    'hazard '*) hazard=${line#hazard } ;;
    'guard '*) guard=${line#guard } ;;
    'file '*) file=${line#file } files+=("$file") ;;
    'cut '*) cut=${line#cut } ;;
    put*)
      put=${line#put} put=${put# }
      exchange "$file" "$cut" "$put" || { echo "guards: $file does not have once: $cut" >&2; exit 65; }
      ;;
    'red '*) red+=("${line#red }") ;;
    '') judge ;;
    *) echo "guards.txt: $line" >&2; exit 65 ;;
  esac
done <tests/guards/guards.txt
judge

echo "$((seen - survived)) of $seen guards seen red without them (the list has $number)"
[ "$survived" -eq 0 ]
