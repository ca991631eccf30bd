#!/bin/sh
# SPDX-License-Identifier: MIT
# compress.sh FOLDER: compresses each text file of a page with gzip to NAME.gz, which is sent to most browsers.
set -eu

find "${1:?compress.sh FOLDER}" -type f \( -name '*.html' -o -name '*.js' -o -name '*.css' -o -name '*.svg' \) \
  -exec gzip --best --no-name --keep --force {} +
