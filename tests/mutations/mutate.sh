#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Changes one operator, constant or statement of the safety code at a time and requires a failing test. Needs `make dev`.
# mutate.sh [--changed [BASE]] [--again] [--file TEXT]... [--every N] [--most N] [--seconds S] [--list]
#   --changed  only lines that differ from BASE (default: the merge base with origin/main, else HEAD~1), and, unless given
#              otherwise, 40 mutants and 180 seconds at most
#   --again    only those that have survived, or were left, since they were last killed
#   --file     only files whose path contains TEXT; may be repeated
#   --every    every N-th mutant
#   --most     at most N mutants, drawn at random with the commit as the seed
#   --seconds  starts no mutant after S seconds
#   --list     only prints the mutants
# JOBS: mutants at a time. Exit: 0 all killed or explained, 1 one survived or could not be tested, 64 usage, 65 an
# explanation quotes a line that does not exist, 70 the tests fail without a mutant, or another mutate.sh runs here.
set -euo pipefail

usage() {
  sed -nE '4,12s/^# ?//p' "${BASH_SOURCE[0]}" >&2
  exit 64
}
number() {
  [[ ${1-} =~ ^[1-9][0-9]*$ ]] || usage
  printf '%s' "$1"
}

changed='' again='' base='' every=1 most='' seconds='' list='' wanted=()
while [ $# -gt 0 ]; do
  case $1 in
    --changed)
      changed=1
      if [ $# -gt 1 ] && [[ $2 != --* ]]; then base=$2; shift; fi
      ;;
    --again) again=1 ;;
    --file) [ $# -gt 1 ] || usage; wanted+=("$2"); shift ;;
    --every) every=$(number "${2-}"); shift ;;
    --most) most=$(number "${2-}"); shift ;;
    --seconds) seconds=$(number "${2-}"); shift ;;
    --list) list=1 ;;
    *) usage ;;
  esac
  shift
done
if [ -n "$changed" ]; then
  most=${most:-40}
  seconds=${seconds:-180}
fi

cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."
work=build/mutations
if [ -n "$list" ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
else
  mkdir -p build
  exec 9>build/.lock-mutations
  flock -n 9 || { echo "mutations: others are being judged here" >&2; exit 70; }
fi
# Of earlier runs, those that were not killed: file, text, mutation, text before.
alive=build/mutations-alive
rm -rf "$work"
mkdir -p "$work"
# Objects of mutants are used once only, so they are not cached.
export CCACHE_DISABLE=1 RC_PARAMS=seed=7
# shellcheck source=tests/mutations/scope.sh
. tests/mutations/scope.sh
scope_into "$work"

# All mutants: file, judges, compiled, line, offset, length, put, mutation, text, text before.
while IFS=$'\t' read -r file judges compiled made; do
  awk -f tests/mutations/mutants.awk "$file" | sort -s -n -k1,1 |
    awk -F '\t' -v head="$file"$'\t'"$judges"$'\t'"$compiled" -v made="$made" '
      made == "elsewhere" && $6 !~ /constexpr/ && $6 ~ /^[A-Za-z_:<>0-9, ]+ [a-z0-9_]+(\[[A-Za-z]+\])?( = |\{)[-A-Za-z0-9.,'"\\'"' {}]*;/ { next }
      { print head "\t" $0 }'
done <"$work/files" >"$work/all"

# The entries of explained.txt: file, text, mutation, text before ("" is any).
awk '
  /^file / { file = substr($0, 6) }
  /^line / { text = substr($0, 6); before = "" }
  /^after / { before = substr($0, 7) }
  /^mutation / { key[++n] = file "\t" text "\t" substr($0, 10) "\t" before }
  /^because / { for (; n > 0; --n) print key[n] }
  END { if (n > 0) { print "mutations: explained.txt ends without a reason" >"/dev/stderr"; exit 65 } }
  ' tests/mutations/explained.txt >"$work/explained"
awk -F '\t' '
  FILENAME == ARGV[1] { made[$1 FS $9 FS $8 FS $10]; made[$1 FS $9 FS $8 FS ""]; next }
  !($0 in made) { print "mutations: explained.txt explains what is not there: " $0; lost = 1 }
  END { exit lost }' "$work/all" "$work/explained" >&2 || exit 65

# The lines that differ from BASE: file, line.
changed_lines() {
  if [ -z "$base" ]; then
    base=$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse --verify -q HEAD~1) || {
      echo "mutations: no commit to compare with; none made" >&2
      return
    }
    # A branch without a difference from BASE is compared with its last commit.
    if git diff --quiet "$base"; then base=$(git rev-parse --verify -q HEAD~1) || return 0; fi
  fi
  git diff -U0 "$base" -- | awk '
    /^\+\+\+ / { file = substr($2, 3) }
    /^@@ / {
      split(substr($3, 2), part, ",")
      for (k = 0; k < (part[2] == "" ? 1 : part[2]); ++k) print file "\t" part[1] + k
    }'
}

cp "$work/all" "$work/selected"
keep() { mv "$work/kept" "$work/selected"; }
if [ -n "$changed" ]; then
  changed_lines >"$work/changed"
  awk -F '\t' 'FILENAME == ARGV[1] { on[$0]; next } ($1 FS $4) in on' "$work/changed" "$work/selected" >"$work/kept"
  keep
fi
if [ -n "$again" ]; then
  [ -f "$alive" ] || { echo "mutations: no earlier run is known here" >&2; exit 64; }
  awk -F '\t' '
    FILENAME == ARGV[1] { alive[$0]; next }
    { key = $1 FS $9 FS $8 FS $10 }
    key in alive { print; made[key] }
    END {
      for (key in alive) lost += !(key in made)
      if (lost > 0) print "mutations: " lost " that survived are not made any more; their lines have changed" >"/dev/stderr"
    }' "$alive" "$work/selected" >"$work/kept"
  keep
fi
if [ ${#wanted[@]} -gt 0 ]; then
  cut -f 1 "$work/files" | grep -qF "$(printf '%s\n' "${wanted[@]}")" || { echo "mutations: no such file in scope.txt" >&2; exit 64; }
  printf '%s\n' "${wanted[@]}" >"$work/wanted"
  awk -F '\t' 'FILENAME == ARGV[1] { part[$0]; next } { for (p in part) if (index($1, p)) { print; next } }' \
    "$work/wanted" "$work/selected" >"$work/kept"
  keep
fi
awk -v every="$every" '(NR - 1) % every == 0' "$work/selected" >"$work/kept"
keep
awk -F '\t' '
  FILENAME == ARGV[1] { explained[$0]; next }
  {
    key = $1 FS $9 FS $8 FS
    print (key in explained || (key $10) in explained) FS $0
  }' "$work/explained" "$work/selected" >"$work/kept"
keep
grep '^1' "$work/selected" | cut -f 2- >"$work/known" || true
grep '^0' "$work/selected" | cut -f 2- >"$work/chosen" || true
if [ -n "$most" ] && [ "$(wc -l <"$work/chosen")" -gt "$most" ]; then
  cp "$work/chosen" "$work/offered"
  nl -ba -w1 "$work/offered" | shuf -n "$most" --random-source=<(yes "$(git rev-parse HEAD)") | sort -n |
    cut -f 2- >"$work/chosen"
  echo "mutations: $most of $(wc -l <"$work/offered") drawn; the others are left out"
fi
if [ -n "$list" ]; then
  awk -F '\t' '{ printf "%s:%d\t%s\t%s\n", $1, $4, $8, $9 }' "$work/chosen"
  exit 0
fi

# The tests must pass without a mutant; with one, each may take a minute longer.
cut -f 2 "$work/chosen" | sort -u >"$work/used"
while read -r judges; do
  while read -r program filter; do
    begun=$SECONDS
    "build/dev/tests/test_$program" --gtest_filter="$filter" --gtest_brief=1 >"$work/log" 2>&1 || {
      tail -n 20 "$work/log" >&2
      echo "mutations: test_$program fails without a mutant: $filter" >&2
      exit 70
    }
    echo "$program $filter $((SECONDS - begun + 60))"
  done <"$work/judges.$judges" >"$work/limits.$judges"
done <"$work/used"

# shellcheck source=tests/relink.sh
. tests/relink.sh
list_commands "$work/commands"
: >"$work/results"
[ -z "$seconds" ] || export MUTATIONS_END=$(($(date +%s) + seconds))
seq "$(wc -l <"$work/chosen")" | xargs -r -P "${JOBS:-2}" -n 1 tests/mutations/test_mutant.sh || true

touch "$alive"
awk -F '\t' '
  FILENAME == ARGV[1] { judged[$3 FS $11 FS $10 FS $12] = $1 ~ /^(survived|left|broken)$/; next }
  !($0 in judged)
  END { for (key in judged) if (judged[key]) print key }' "$work/results" "$alive" | sort -u >"$work/alive"
mv "$work/alive" "$alive"

awk -F '\t' '
  FILENAME == ARGV[1] { ++known[$1]; files[$1]; next }
  FILENAME == ARGV[2] { ++judged; ++of[$3, $1]; ++sum[$1]; files[$3] }
  FILENAME == ARGV[3] { ++chosen }
  FILENAME == ARGV[2] && $1 == "broken" { print "BROKEN    " $3 ":" $6 "  " $10 ": " $2 }
  function row(name, killed, late, survived, explained, nonviable, left) {
    printf "%-46s %7d %7d %9d %10d %10d %7d\n", name, killed, late, survived, explained, nonviable, left
  }
  END {
    printf "%-46s %7s %7s %9s %10s %10s %7s\n", "mutants", "killed", "no end", "survived", "explained", "nonviable", "left"
    sorted = "sort"
    for (f in files) {
      all += known[f]
      printf "%-46s %7d %7d %9d %10d %10d %7d\n", f, of[f, "killed"], of[f, "late"], of[f, "survived"], known[f],
        of[f, "nonviable"], of[f, "left"] | sorted
    }
    close(sorted)
    row("all", sum["killed"], sum["late"], sum["survived"], all, sum["nonviable"], sum["left"])
    if (judged != chosen) print chosen - judged " were not judged"
    exit sum["survived"] + sum["broken"] > 0 || judged != chosen
  }' "$work/known" "$work/results" "$work/chosen"
