#!/bin/sh
# SPDX-License-Identifier: MIT
# The image on an emulated RP2040. run.sh ELF PLANT PACKAGES PROGRAMS [WHAT...]: hedgehog-board.elf, the program firmware_plant, a folder
# for npm's packages, and the build folder of hedgehogd. WHAT:
#   (nothing)                       all tests, and their coverage
#   test NAME [PATTERN]             NAME.test.mjs, or those of its tests whose name matches PATTERN
#   guards FIRMWARE_IMAGE [--third] [WORD]  guards.mjs
#   play MINUTES [SEED]             play.mjs
#   usbip SOCKET                    usbip.mjs
# HEDGEHOG_FIRMWARE_TICKS: number of frames compared with the host's core (3000). Exit: 0 all passed.
set -eu

[ $# -ge 4 ] || { echo "run.sh ELF PLANT PACKAGES PROGRAMS [test NAME [PATTERN] | guards FIRMWARE_IMAGE [--third] [WORD] | play MINUTES [SEED] | usbip SOCKET]" >&2; exit 64; }
here=$(cd -- "$(dirname -- "$0")" && pwd)
HEDGEHOG_FIRMWARE_ELF=$(realpath "$1")
HEDGEHOG_FIRMWARE_PLANT=$(realpath "$2")
mkdir -p "$3"
HEDGEHOG_NODE_MODULES=$(realpath "$3")/node_modules
HEDGEHOG_PROGRAMS=$(realpath "$4")
export HEDGEHOG_FIRMWARE_ELF HEDGEHOG_FIRMWARE_PLANT HEDGEHOG_NODE_MODULES HEDGEHOG_PROGRAMS
"$here/../../../cmake/npm.sh" "$here" "$3"
shift 4
timeout_ms=$((600000 + 10 * ${HEDGEHOG_FIRMWARE_TICKS:-0}))
case ${1-} in
  "") ;;
  guards | play | usbip)
    program=$here/$1.mjs
    shift
    exec node "$program" "$@" ;;
  test)
    counts=$(mktemp)
    trap 'rm -f "$counts"' EXIT
    "$here/../../node_test.sh" "$timeout_ms" --test-reporter=spec --test-reporter-destination=stdout \
      --test-reporter=tap "--test-reporter-destination=$counts" "--test-name-pattern=${3-.}" "$here/$2.test.mjs"
    # A pattern that matches no name runs nothing, which node reports as a success.
    grep -q '^# pass [1-9]' "$counts" || { echo "run.sh: no test of $2 is named '${3-.}'" >&2; exit 64; }
    exit ;;
  *) echo "run.sh: $1?" >&2; exit 64 ;;
esac
HEDGEHOG_FIRMWARE_COVERAGE=$(mktemp -d)
export HEDGEHOG_FIRMWARE_COVERAGE
trap 'rm -rf "$HEDGEHOG_FIRMWARE_COVERAGE"' EXIT
"$here/../../node_test.sh" "$timeout_ms" --test-concurrency=2 --test-reporter=spec "$here"/*.test.mjs
node "$here/coverage.mjs" "$HEDGEHOG_FIRMWARE_ELF" "$HEDGEHOG_FIRMWARE_COVERAGE"
