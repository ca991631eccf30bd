#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh HEDGEHOGD: compiles clients/unity with Mono, runs conformance.json on it, and tests it with the simulated daemon.
# HEDGEHOG_SLOW_NAMES: the library of slow_names.cpp. Exit: 0 passed.
set -euo pipefail

[ $# -eq 1 ] || { echo "run.sh HEDGEHOGD" >&2; exit 64; }
hedgehogd=$1
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
package=$here/../../../clients/unity
work=$(mktemp -d)
daemon=
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [ -z "$daemon" ] || { kill "$daemon" && wait "$daemon"; } 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT

fail() { echo "tests/sdk/unity: $*" >&2; exit 1; }
# run PROGRAM ARGUMENT...: terminates a program that hangs; the timeout of the tests' calls is a minute.
run() {
  local program=$1
  shift
  timeout 300 mono "$work/bin/$program" "$@"
}

python3 "$package/generate.py" --check || fail "run clients/unity/generate.py"
# Code for ahead-of-time compilers must be complete at compile time.
forbidden='System\.Reflection|\bdynamic\b|Activator|\.GetType\(|\.Emit|Linq\.Expressions|MakeGeneric|DllImport'
! grep -rnE "$forbidden" "$package/Runtime" --include='*.cs' || fail "reflection, generated or native code"

# The core is a library for .NET Standard 2.0; a newer member and a type of .NET Framework are found.
"$here/standard.sh" "$package/Runtime/Core" || fail "not .NET Standard 2.0"
for newer in 'bool New { get { return "ball".Contains('"'b'"'); } }' 'System.AppDomainSetup New;'; do
  mkdir "$work/newer"
  echo "class Newer { $newer }" >"$work/newer/newer.cs"
  ! "$here/standard.sh" "$work/newer" >"$work/newer/found" 2>&1 || fail "standard.sh does not find: $newer"
  grep -qE 'CS1503|CS1061|AppDomainSetup' "$work/newer/found" || fail "standard.sh fails otherwise: $(cat "$work/newer/found")"
  rm -r "$work/newer"
done

# assembly NAME FOLDER REFERENCE...: compiles a folder into a library.
assembly() {
  local name=$1 folder=$2
  shift 2
  compile -target:library -out:"$work/bin/$name.dll" "${@/#/-r:$work/bin/}" -recurse:"$package/$folder/*.cs"
}
compile() { mcs -noconfig -langversion:7.2 -warnaserror+ -warn:4 -r:System.dll "$@"; }
mkdir "$work/bin"
assembly Hedgehog.Client Runtime/Core
compile -target:library -out:"$work/bin/UnityStub.dll" "$here/unity_stub.cs"
assembly Hedgehog.Unity Runtime/Unity Hedgehog.Client.dll UnityStub.dll
assembly Hedgehog.Editor Editor Hedgehog.Client.dll Hedgehog.Unity.dll UnityStub.dll
assembly Hedgehog.Samples.Racer Samples~/Racer Hedgehog.Client.dll Hedgehog.Unity.dll UnityStub.dll
all=(-r:"$work/bin/Hedgehog.Client.dll" -r:"$work/bin/Hedgehog.Unity.dll" -r:"$work/bin/Hedgehog.Editor.dll"
  -r:"$work/bin/Hedgehog.Samples.Racer.dll" -r:"$work/bin/UnityStub.dll")
# Compiled with the library's sources, for access to internal members.
compile -out:"$work/bin/core_test.exe" -r:System.Core.dll "$here/check.cs" "$here/core_test.cs" "$here/connect_test.cs" \
  -recurse:"$package/Runtime/Core/*.cs"
compile -out:"$work/bin/conformance.exe" "${all[@]}" -r:System.Core.dll "$here/check.cs" "$here/conformance.cs" \
  "$here/libraries.cs" "$here/ended_enumeration.cs"
compile -out:"$work/bin/live.exe" "${all[@]}" "$here/check.cs" "$here/relay.cs" "$here/live.cs" "$here/live_component.cs"

HEDGEHOG_NAMES_KNOWN=$work/known LD_PRELOAD=$HEDGEHOG_SLOW_NAMES run core_test.exe
run conformance.exe "$here/.."

export HOME=$work XDG_CONFIG_HOME=$work XDG_STATE_HOME=$work XDG_RUNTIME_DIR=$work
# The first place that clients search, so that they find this daemon before an installed one.
export RUNTIME_DIRECTORY=$work/hedgehog
unset HEDGEHOG_ADDRESS STATE_DIRECTORY
mkfifo "$work/listening"
exec 3<>"$work/listening"
# In step with the control loop, so that a busy machine does not lose the simulated board.
"$hedgehogd" --simulate --speed 1 --listen 127.0.0.1:0 >"$work/listening" 2>"$work/daemon.log" &
daemon=$!
address=
while [ -z "$address" ]; do
  read -r -t 120 line <&3 || { cat "$work/daemon.log"; fail "the daemon did not start"; }
  address=$(printf '%s\n' "$line" | sed -n 's/^listening on \(127\.0\.0\.1:[0-9]*\)$/\1/p')
done
run live.exe "$address"
# The same behind TLS, which the library does not have.
PYTHONDONTWRITEBYTECODE=1 timeout 300 python3 "$here/../through_tunnel.py" "$hedgehogd" mono "$work/bin/live.exe"

# The README's first example, at most ten lines, in an empty folder, with the README's commands; with the address, and with the
# socket that the library finds.
awk '/^```csharp$/ { on = 1; next } /^```$/ { if (on) exit } on' "$package/README.md" >"$work/game.cs"
lines=$(wc -l <"$work/game.cs")
if [ "$lines" -lt 5 ] || [ "$lines" -gt 10 ]; then fail "the README's first example has $lines lines"; fi
mkdir "$work/empty"
cd "$work/empty"
mv "$work/game.cs" .
mcs -recurse:"$package/Runtime/Core/*.cs" game.cs -out:game.exe
for place in "$address" ""; do
  celsius=$(HEDGEHOG_ADDRESS=$place LC_ALL=C mono game.exe)
  awk -v c="$celsius" 'BEGIN { exit !(c > 10 && c < 60) }' || fail "the README's first example prints '$celsius'"
done
# The second example is a script for Unity.
awk '/^```csharp$/ { ++n; next } /^```$/ { if (n == 2) exit; next } n == 2' "$package/README.md" >Crash.cs
compile -target:library "${all[@]}" -out:crash.dll Crash.cs
echo "tests/sdk/unity: all is well"
