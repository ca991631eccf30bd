#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# To be sourced: compiles changed sources, or with other options, and links them into the programs of build/dev. A source
# must not be in a batch (cmake/compiler.cmake); the linker then omits the archive's own object.
# relink_dev: the build. relink_commands: the file of its compile and link commands, one a line (list_commands).
relink_dev=build/dev

# list_commands FILE
list_commands() {
  relink_commands=$1
  [ -s "$relink_commands" ] || ninja -C "$relink_dev" -t commands all >"$relink_commands"
}

# command_with TEXT: prints the first command that contains TEXT, or, if TEXT ends in '$', that ends with the text before
# it.
command_with() {
  TEXT=$1 awk '
    BEGIN { text = ENVIRON["TEXT"]; last = sub(/\$$/, "", text) }
    (at = index($0, text)) && (!last || at + length(text) - 1 == length($0)) { print; exit }' "$relink_commands"
}

# compile_as_built FILE SOURCE OBJECT [OPTION...]: compiles SOURCE as the build compiles FILE, without warnings. Returns 1:
# it does not compile; 2: FILE is compiled in a batch, or not at all.
compile_as_built() {
  local command
  command=$(command_with " -c $PWD/$1\$")
  [ -n "$command" ] || return 2
  command=${command%% -MD *}" -w -o $3 -c $2"
  (cd "$relink_dev" && bash -c "${command/++ /++ ${*:4} }") || return 1
}

# link_as_built PLACE PROGRAM INSERTED...: links the build's program PLACE as PROGRAM, with the objects and options INSERTED
# first. Returns 1: it does not link; 2: there is no such program.
link_as_built() {
  local command
  command=$(command_with " -o $1 ")
  [ -n "$command" ] || return 2
  command=${command/ -o $1 / -o $2 }
  mkdir -p "$(dirname -- "$2")"
  (cd "$relink_dev" && bash -c "${command/++ /++ ${*:3} }") && [ -x "$2" ]
}
