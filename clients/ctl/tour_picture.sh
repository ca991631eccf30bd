#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes tour.svg, the picture in the project's README, from a real run of the tour: it plays in a terminal of tmux, and
# the frame of its seventh second is written as text in an SVG. Usage: tour_picture.sh HEDGEHOGCTL > tour.svg
set -eu

program=${1:?usage: tour_picture.sh HEDGEHOGCTL > tour.svg}
session="hedgehog-tour-$$"
frame=$(mktemp)
trap 'tmux kill-session -t "$session" 2>/dev/null; rm -f "$frame"' EXIT

tmux -f /dev/null new-session -d -s "$session" -x 80 -y 22 "LANG=C.UTF-8 '$program' demo --private"
# Taken while a push to the left is at its height: waits for the strong marks, not for a time.
tries=0
while [ $tries -lt 400 ]; do
  tmux capture-pane -p -t "$session" >"$frame"
  if grep -q '"direction":"left"' "$frame" && grep -q ' 10.0 A  ' "$frame"; then
    break
  fi
  tries=$((tries + 1))
  sleep 0.05
done
[ $tries -lt 400 ] || { echo "tour_picture.sh: the push to the left was never seen" >&2; exit 1; }

cat <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="720" height="440" viewBox="0 0 720 440" role="img"
 aria-label="A terminal: the ball unrolled like a map, strong marks on its left, temperature and current below">
<rect width="720" height="440" rx="8" fill="#14181d"/>
<g font-family="DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="14" fill="#d7dce2">
SVG
# Every word gets its own place, so that the columns hold in any font. Byte by byte: UTF-8 continues with 10xxxxxx.
LC_ALL=C awk '
BEGIN { for (i = 0; i < 256; i++) code[sprintf("%c", i)] = i }
function put() {
  if (word != "") printf "<text y=\"%d\" x=\"%.1f\">%s</text>\n", 30 + 19 * (NR - 1), 20 + 8.43 * start, word
  word = ""
}
{
  word = ""; column = 0
  for (i = 1; i <= length($0); i++) {
    byte = substr($0, i, 1)
    if (code[byte] >= 128 && code[byte] < 192) { word = word byte; continue }
    if (byte == " ") put()
    else {
      if (word == "") start = column
      word = word (byte == "&" ? "&amp;" : byte == "<" ? "&lt;" : byte == ">" ? "&gt;" : byte)
    }
    column++
  }
  put()
}' "$frame"
printf '</g>\n</svg>\n'
