#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# To be sourced: sources compiled otherwise than build/dev has them, and linked into its programs. A source must be in no
# batch (cmake/compiler.cmake); an archive's own object is then left out by the linker.
# relink_dev: the build. relink_commands: what compiles and links it, a command a line (list_commands).
relink_dev=build/dev

# list_commands FILE
list_commands() {
  relink_commands=$1
  [ -s "$relink_commands" ] || ninja -C "$relink_dev" -t commands all >"$relink_commands"
}

# command_with TEXT: the first command that has the text, of which what stands before `end of line` is the end when the
# text ends in '$'.
command_with() {
  TEXT=$1 awk '
    BEGIN { text = ENVIRON["TEXT"]; last = sub(/\$$/, "", text) }
    (at = index($0, text)) && (!last || at + length(text) - 1 == length($0)) { print; exit }' "$relink_commands"
}

# compile_as_built FILE SOURCE OBJECT [OPTION...]: SOURCE as the build compiles FILE, without warnings. 1: it does not
# compile; 2: FILE is compiled in a batch, or not at all.
compile_as_built() {
  local command
  command=$(command_with " -c $PWD/$1\$")
  [ -n "$command" ] || return 2
  command=${command%% -MD *}" -w -o $3 -c $2"
  (cd "$relink_dev" && bash -c "${command/++ /++ ${*:4} }") || return 1
}

# link_as_built PLACE PROGRAM INSERTED...: the program that the build has in PLACE, with these objects and options first.
# 1: it does not link; 2: there is no such program.
link_as_built() {
  local command
  command=$(command_with " -o $1 ")
  [ -n "$command" ] || return 2
  command=${command/ -o $1 / -o $2 }
  mkdir -p "$(dirname -- "$2")"
  (cd "$relink_dev" && bash -c "${command/++ /++ ${*:3} }") && [ -x "$2" ]
}
