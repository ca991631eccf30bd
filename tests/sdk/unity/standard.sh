#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# standard.sh FOLDER: whether the C# in a folder uses only .NET Standard 2.0: it is compiled with the members of .NET Framework
# 4.6.1, which implements that standard and nothing newer, and its assembly must refer to types of the standard only. A member that
# only .NET Framework has, of a type that both have, is not found.
# Exit: 0, 1 what is not in the standard was printed, 69 the reference assemblies are not available.
set -euo pipefail

[ $# -eq 1 ] || { echo "standard.sh FOLDER" >&2; exit 64; }
references=$("$(dirname -- "${BASH_SOURCE[0]}")/reference.sh") || exit 69
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mcs -noconfig -nostdlib -langversion:7.2 -warn:0 -target:library -out:"$work/library.dll" -r:"$references/mscorlib.dll" \
  -r:"$references/System.dll" -r:"$references/System.Core.dll" -recurse:"$1/*.cs" || exit 1

# Namespace.Type of each type that the library refers to, and of each type of the standard; a nested one belongs to its outer type.
monodis --typeref "$work/library.dll" | sed -n 's/^[0-9]*: \[.*\]//p' | sed 's,/.*,,' | sort -u >"$work/used"
monodis --exported "$references/netstandard.dll" | sed -n 's/^[0-9]*: \(.*\) is in .*/\1/p' | sort -u >"$work/standard"
for list in used standard; do
  [ -s "$work/$list" ] || { echo "standard.sh: monodis lists no types" >&2; exit 1; }
done
comm -23 "$work/used" "$work/standard" >"$work/others"
[ ! -s "$work/others" ] || { sed 's/^/not in .NET Standard 2.0: /' "$work/others"; exit 1; }
