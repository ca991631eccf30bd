#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# To be sourced: splits scope.txt into files. scope_into FOLDER writes
#   FOLDER/files   file, number N of its judges, source that is compiled for it, "elsewhere" or nothing; separated by tabs
#   FOLDER/covered the files of which every line must be executed
#   FOLDER/constants  file and the first line of a block that only the compiler evaluates
#   FOLDER/judges.N  program and filter, a judge a line
scope_into() {
  awk -v folder="$1" '
    $1 == "tests" {
      if (!grouping) ++judges
      grouping = 1
      print $2, $3 >(folder "/judges." judges)
    }
    $1 == "file" || $1 == "covered" {
      grouping = 0
      print $2 "\t" judges "\t" ($3 == "through" ? $4 "\t" $5 : $2) >(folder "/files")
      if ($1 == "covered") {
        print $2 >(folder "/covered")
        if ($3 == "but") print $2 "\t" substr($0, index($0, " but ") + 5) >(folder "/constants")
      }
    }' tests/mutations/scope.txt
}
