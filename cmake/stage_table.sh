#!/bin/sh
# SPDX-License-Identifier: MIT
# stage_table.sh STAGES JSON: converts the lines of stage.sh, each_target.sh, tests/run.sh, tests/vm/test.sh and .ci/run to a
# table on stdout and to JSON in a file. The last line counts the tests that ctest and the emulated machine ran.
set -eu

[ $# -eq 2 ] || { echo "stage_table.sh STAGES JSON" >&2; exit 64; }

awk -F '\t' '
  function clock(s) { return sprintf("%d:%02d", int((s + 0.5) / 60), int(s + 0.5) % 60) }
  BEGIN { printf "\n%-34s %8s %8s\n", "stage", "clock", "cores" }
  $1 == "stage" {
    printf "%-34s %8s %8.1f%s\n", $2, clock($3), ($3 > 0 ? $4 / $3 : 0), ($5 == 0 ? "" : "   exit " $5)
    wall += $3; cpu += $4
  }
  $1 == "program" { printf "  %-32s %8s          %d tests, their times added up\n", $2, clock($3), $4 }
  $1 == "whole" { whole = $2 }
  $1 == "repeated" { repeated = repeated "  " $2 "\n" }
  $1 == "late" { late = late "  " $2 "\n" }
  $1 == "red" { red = red "  " $2 "\n" }
  $1 == "failure" { failures = failures "  " $2 "\n" }
  $1 == "tests" { run += $2; failed += $3; skipped += $4 }
  END {
    printf "%-34s %8s          some side by side\n", "all stages", clock(wall)
    if (whole) printf "%-34s %8s %8.1f\n", "the whole run", clock(whole), cpu / whole
    printf "\nclock tests that were repeated:%s\n", (repeated == "" ? " none" : "\n" repeated)
    if (failures != "") printf "\nfailed twice:\n%s", failures
    if (red != "") printf "\nfailed targets:\n%s", red
    if (late != "") printf "\nnot begun for want of time:\n%s", late
    printf "\n%d passed, %d failed, %d skipped\n", run - failed - skipped, failed, skipped
  }' "$1"

awk -F '\t' '
  function text(s) { gsub(/\\/, "\\\\", s); gsub(/"/, "\\\"", s); return "\"" s "\"" }
  $1 == "stage" {
    stages = stages comma[1] sprintf("\n    {\"stage\": %s, \"clock_s\": %s, \"cpu_s\": %s, \"exit\": %s}", text($2), $3, $4, $5)
    comma[1] = ","
  }
  $1 == "program" {
    programs = programs comma[2] sprintf("\n    {\"program\": %s, \"tests\": %s, \"sum_s\": %s}", text($2), $4, $3)
    comma[2] = ","
  }
  $1 == "whole" { whole = $2 }
  $1 == "late" { late = late comma[4] "\n    " text($2); comma[4] = "," }
  $1 == "red" { red = red comma[5] "\n    " text($2); comma[5] = "," }
  $1 == "repeated" { repeated = repeated comma[3] "\n    " text($2); comma[3] = "," }
  $1 == "tests" { run += $2; failed += $3; skipped += $4 }
  END {
    printf "{\n"
    if (whole) printf "  \"whole_s\": %s,\n", whole
    printf "  \"stages\": [%s\n  ],\n  \"programs\": [%s\n  ],\n  \"repeated\": [%s],\n  \"not_begun\": [%s],\n  \"failed\": [%s],\n", stages, programs, repeated, late, red
    printf "  \"tests\": {\"passed\": %d, \"failed\": %d, \"skipped\": %d}\n}\n", run - failed - skipped, failed, skipped
  }' "$1" >"$2"
