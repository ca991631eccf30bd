#!/bin/sh
# SPDX-License-Identifier: MIT
# npm.sh FOLDER TARGET: installs the packages of FOLDER/package-lock.json in TARGET/node_modules, unless they are there already.
set -eu

from=$1
to=$2
mkdir -p "$to"
# When two run at once, one installs and the other waits.
exec 9>"$to/.lock"
flock 9
if [ -d "$to/node_modules" ] && cmp -s "$from/package-lock.json" "$to/.installed"; then
  exit 0
fi
cp "$from/package.json" "$from/package-lock.json" "$to/"
(cd "$to" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error)
cp "$from/package-lock.json" "$to/.installed"
