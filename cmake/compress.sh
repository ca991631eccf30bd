#!/bin/sh
# SPDX-License-Identifier: MIT
# compress.sh FOLDER: beside each text of a page one packed by gzip, NAME.gz, which is what most browsers are sent.
set -eu

find "${1:?compress.sh FOLDER}" -type f \( -name '*.html' -o -name '*.js' -o -name '*.css' -o -name '*.svg' \) \
  -exec gzip --best --no-name --keep --force {} +
