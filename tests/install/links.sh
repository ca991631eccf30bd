#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# links.sh FOLDER: whether the links of the documents FOLDER/*.md to files lead to files. Exit: 0 all do, 1 some lead nowhere or
# there are none, 64 usage.
set -euo pipefail

[ $# -eq 1 ] || { echo "links.sh FOLDER" >&2; exit 64; }
cd "$1"
count=0
code=0
for document in *.md; do
  while read -r link; do
    count=$((count + 1))
    [ -e "${link%%#*}" ] || { echo "$1/$document: the link to $link leads nowhere" >&2; code=1; }
  done < <(grep -oE '\]\([^):#]+(#[^)]*)?\)' "$document" | sed 's/^](//; s/)$//')
done
[ "$count" -gt 0 ] || { echo "$1: no links" >&2; code=1; }
[ "$code" != 0 ] || echo "links.sh: $count links"
exit "$code"
