#!/bin/sh
# SPDX-License-Identifier: MIT
# The image on an emulated RP2040. run.sh ELF PLANT PACKAGES PROGRAMS [guards FIRMWARE_IMAGE [WORD]]: hedgehog-board.elf, the program
# firmware_plant, a folder for npm's packages, and the build folder of hedgehogd; with `guards` as guards.mjs says.
# HEDGEHOG_FIRMWARE_TICKS: so many frames are compared with the host's core (3000). Exit: 0 all passed.
set -eu

[ $# -eq 4 ] || [ "${5-}" = guards ] || { echo "run.sh ELF PLANT PACKAGES PROGRAMS [guards FIRMWARE_IMAGE [WORD]]" >&2; exit 64; }
here=$(cd -- "$(dirname -- "$0")" && pwd)
HEDGEHOG_FIRMWARE_ELF=$(realpath "$1")
HEDGEHOG_FIRMWARE_PLANT=$(realpath "$2")
mkdir -p "$3"
HEDGEHOG_NODE_MODULES=$(realpath "$3")/node_modules
HEDGEHOG_PROGRAMS=$(realpath "$4")
export HEDGEHOG_FIRMWARE_ELF HEDGEHOG_FIRMWARE_PLANT HEDGEHOG_NODE_MODULES HEDGEHOG_PROGRAMS
"$here/../../../cmake/npm.sh" "$here" "$3"
if [ $# -gt 4 ]; then
  shift 5
  exec node "$here/guards.mjs" "$@"
fi
HEDGEHOG_FIRMWARE_COVERAGE=$(mktemp -d)
export HEDGEHOG_FIRMWARE_COVERAGE
trap 'rm -rf "$HEDGEHOG_FIRMWARE_COVERAGE"' EXIT
node --test --test-concurrency=2 --test-timeout=$((600000 + 10 * ${HEDGEHOG_FIRMWARE_TICKS:-0})) --test-reporter=spec "$here"/*.test.mjs
node "$here/coverage.mjs" "$HEDGEHOG_FIRMWARE_ELF" "$HEDGEHOG_FIRMWARE_COVERAGE"
