#!/bin/sh
# SPDX-License-Identifier: MIT
# reference.sh: prints the folder of the reference assemblies of .NET Framework 4.6.1, the oldest that runs libraries for .NET
# Standard 2.0, and of netstandard.dll, which lists that standard's types. They are in Debian's mono-devel, whose dependencies take
# hundreds of megabytes: unless it is installed, it is unpacked into HEDGEHOG_MONO_CACHE (default ~/.cache/hedgehog-mono).
# Exit: 0, 69 it is not available.
set -eu

cache=${HEDGEHOG_MONO_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/hedgehog-mono}
mono=usr/lib/mono
framework=$mono/4.6.1-api
standard=$mono/4.7.1-api/Facades/netstandard.dll

give_up() { echo "reference.sh: $*" >&2; exit 69; }

# collect ROOT FOLDER
collect() {
  for assembly in mscorlib System System.Core; do
    cp "$1/$framework/$assembly.dll" "$2/" || give_up "mono-devel has no $framework/$assembly.dll"
  done
  cp "$1/$standard" "$2/" || give_up "mono-devel has no $standard"
}

if [ ! -s "$cache/ready/netstandard.dll" ]; then
  mkdir -p "$cache"
  made=$(mktemp -d "$cache/fetch.XXXXXX")
  trap 'rm -rf "$made"' EXIT
  mkdir "$made/ready"
  if [ -s "/$standard" ]; then
    collect / "$made/ready"
  else
    (cd "$made" && apt-get -qq -o Acquire::Retries=3 -o APT::Sandbox::User="$(id -un)" download mono-devel >&2) ||
      give_up "apt-get download mono-devel failed"
    dpkg-deb --fsys-tarfile "$made"/*.deb | tar -x -C "$made" "./$framework" "./$standard"
    collect "$made" "$made/ready"
  fi
  # Another process may have been first; its result is equivalent.
  mv -T "$made/ready" "$cache/ready" 2>/dev/null || [ -s "$cache/ready/netstandard.dll" ] || give_up "cannot write $cache"
fi
echo "$cache/ready"
