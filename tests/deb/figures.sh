#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# figures.sh: prints results of the programs in PATH as lines of JSON (same_figures.py compares them): the magnets' mechanics, the
# daemon's previews, and the windings as measured by `calibrate`. REQUIRES: HEDGEHOG_ADDRESS is an armed simulated ball.
set -euo pipefail

line() { echo "{\"name\":\"$1\",\"figures\":$2}"; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

line array "$(hedgehog-design array --array wD-66 --shield 4x10 --json | tr -d '\n')"
line stability "$(hedgehog-design stability --json | tr -d '\n')"
line pair "$(hedgehog-design pair --magnet 8x10 --other 4x10 --sphere 35 --angle 12 --offset 0.5 --model exact --json | tr -d '\n')"
line electromagnet "$(hedgehog-design electromagnet --pin 17 --current 0..15/5 --json | tr -d '\n')"
for verb in "pulse left" "circle" "vibrate up" "play heartbeat left"; do
  # shellcheck disable=SC2086  # the words of a verb
  line "preview $verb" "$(hedgehogctl preview $verb --json | tr -d '\n')"
done
# On an overloaded machine telemetry is lost: the measurement is rejected, or the ball is disarmed (hot_plug).
for attempt in 1 2 3 4 5; do
  ! hedgehogctl calibrate --force --pushed x=front,y=left,z=up --out "$work/found.json" >"$work/out" 2>&1 || break
  [ "$attempt" -lt 5 ] || { cat "$work/out" >&2; exit 1; }
  hedgehogctl arm >&2 || true
done
# Without comments, which have lines of their own.
line calibrate "$(sed '/^ *\/\//d' "$work/found.json" | tr -d '\n')"
