#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# inside.sh: tests the packages in /packages on a system that never had them; run by run.sh in a fresh root. Prints a transcript.
set -euo pipefail
cd /packages

work=/packages/work
mkdir "$work"
fail() { echo "tests/deb: $*" >&2; exit 1; }
step() { echo; echo "tests/deb: $*"; }
quietly() { "$@" >"$work/out" 2>&1 || { cat "$work/out"; fail "$*"; }; }
# A command with its output; a long one without its output, with its time.
show() { echo "\$ $*"; "$@"; }
timed() {
  local begun=$SECONDS
  echo "\$ $*"
  quietly "$@"
  echo "($((SECONDS - begun)) s)"
}
# figures.sh is here for packages of another architecture: compiling on an emulated processor takes too long.
is_emulated() { [ -e figures.sh ]; }
# Prints every file and account of this project, except the packages themselves.
ours() {
  find / /run -xdev -path /packages -prune -o -name '*hedgehog*' -print | sort
  getent passwd | grep hedgehog || true
  getent group | grep hedgehog || true
}
purge() { timed apt-get purge -y '*hedgehog*'; }

[ -z "$(ours)" ] || fail "this system has known them"
quietly apt-get update
bash snapshot.sh | sort -u >"$work/before"

step "install"
begun=$SECONDS
timed apt-get install -y --no-install-recommends ./before/*.deb
[ -e /etc/systemd/system/multi-user.target.wants/hedgehogd.service ] || fail "the service is not enabled"
for unit in hedgehog-gamepad hedgehog-mqtt; do
  [ ! -e "/etc/systemd/system/multi-user.target.wants/$unit.service" ] || fail "$unit is enabled"
done
[ "$(id -Gn hedgehog)" = hedgehog ] || fail "the user hedgehog: $(id hedgehog)"
[ "$(id -Gn hedgehog-gamepad)" = "hedgehog-gamepad hedgehog" ] || fail "the user hedgehog-gamepad: $(id hedgehog-gamepad)"
! systemd-analyze verify hedgehogd.service 2>&1 | grep -i hedgehog || fail "systemd-analyze verify"

# Starts the daemon as its unit does, without systemd; the simulated board in step with it, for a busy machine loses it otherwise.
daemon=
start() {
  install -d -o hedgehog -g hedgehog /run/hedgehog /var/lib/hedgehog
  mkfifo "$work/listening"
  exec 3<>"$work/listening"
  RUNTIME_DIRECTORY=/run/hedgehog STATE_DIRECTORY=/var/lib/hedgehog CONFIGURATION_DIRECTORY=/etc/hedgehog \
    setpriv --reuid=hedgehog --regid=hedgehog --init-groups hedgehogd --simulate --speed 1 --listen 127.0.0.1:0 >"$work/listening" 2>"$work/daemon.log" &
  daemon=$!
  read -r -t 120 -u 3 line || { cat "$work/daemon.log"; fail "the daemon did not start"; }
  echo "$line"
}
stop() {
  kill "$daemon"
  wait "$daemon" || { cat "$work/daemon.log"; fail "the daemon did not end as it should"; }
  exec 3>&-
  rm -r "$work/listening"
}

start
show hedgehogctl pulse left
echo "from apt install to the first pulse: $((SECONDS - begun)) s"
stop

step "upgrade; the settings are changed here and, without BEFORE, in the package"
settings_in() { dpkg-deb --fsys-tarfile "$1" | tar --extract --to-stdout ./etc/hedgehog/hedgehogd.json; }
settings=/etc/hedgehog/hedgehogd.json
echo '{ "limits": { "current_a": 10 } }' >"$settings"
timed apt-get install -y --no-install-recommends -o Dpkg::Options::=--force-confold ./*.deb
dpkg-query --show --showformat '${Package} ${Version}\n' 'hedgehog*' libhedgehog-dev python3-hedgehog
[ "$(cat "$settings")" = '{ "limits": { "current_a": 10 } }' ] || fail "the upgrade has overwritten the settings"
if [ "$(settings_in before/hedgehogd_*.deb)" = "$(settings_in ./hedgehogd_*.deb)" ]; then
  [ ! -e "$settings.dpkg-dist" ] || fail "$settings.dpkg-dist, although the package's settings are the old ones"
else
  [ "$(cat "$settings.dpkg-dist")" = "$(settings_in ./hedgehogd_*.deb)" ] || fail "the package's settings are not beside those here"
  echo "$settings is kept, $settings.dpkg-dist is the package's"
fi
start
[ "$(hedgehogctl status --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["state"])')" = armed ] || fail "it is not armed"
show hedgehogctl pulse left
python3 -c '
from hedgehog import Ball
with Ball() as ball:
    ball.pulse("left", level=0.5)
    print("python:", ball.status()["state"])'
hedgehogctl check || [ $? = 1 ] || fail "check"
if is_emulated; then
  step "figures"
  cp "$settings" settings.json
  bash figures.sh >figures.json || fail "figures.sh"
fi
for program in hedgehog-gamepad hedgehog-mqtt hedgehog-orientation hedgehog-study hedgehog-design hedgehog-simboard hedgehog-racer; do quietly "$program" --version; done

step "documents and examples"
for package in hedgehogd python3-hedgehog; do bash links.sh "/usr/share/doc/$package"; done
# shellcheck disable=SC2016  # the quotes are those of Markdown
sed -n '/^```python$/,/^```$/{//!p}' /usr/share/doc/python3-hedgehog/README.md >"$work/game.py"
[ -s "$work/game.py" ] || fail "the document of python3-hedgehog has no program"
show python3 "$work/game.py"
lap() { "$@" | tee "$work/lap" && [ "$(grep -c ' s  ' "$work/lap")" = 5 ]; }
quietly lap python3 /usr/share/doc/python3-hedgehog/examples/racer.py
example=/usr/share/doc/libhedgehog-dev/examples/racer.cpp
[ -s "$example" ] || fail "$example is not installed"
if ! is_emulated; then
  timed apt-get install -y --no-install-recommends g++ pkg-config
  # shellcheck disable=SC2046  # flags are words
  timed c++ -std=c++20 -Wall -Wextra "$example" -o "$work/racer" $(pkg-config --cflags --libs hedgehog-client)
  quietly lap "$work/racer"
  quietly apt-get purge -y g++ pkg-config
fi
echo "a lap in Python$(is_emulated || echo " and C++"): $(wc -l <"$work/lap") lines"

step "a trip, tokens, a certificate, settings of another ball"
# What a used machine has.
show python3 trip.py
quietly hedgehogctl token add arcade --role play
quietly hedgehogctl token certificate
stop
for file in state.json trips.jsonl trip-0001.hhr tokens certificate.pem key.pem; do
  [ -s "/var/lib/hedgehog/$file" ] || fail "/var/lib/hedgehog/$file is not there"
done
echo '{}' >/etc/hedgehog/0007.json

step "remove, purge"
timed apt-get remove -y hedgehogd
for file in "$settings" /var/lib/hedgehog/state.json; do [ -s "$file" ] || fail "removing has taken $file"; done
purge
[ "$(find /etc/hedgehog)" = "/etc/hedgehog
/etc/hedgehog/0007.json" ] || fail "purging has not left what others made in /etc/hedgehog, and only that: $(find /etc/hedgehog)"
rm -r /etc/hedgehog
left=$(ours)
[ -z "$left" ] || fail "left behind: $left"
# What other packages that came along leave behind is not ours: the whole system is as before when they have gone, too.
timed apt-get autoremove --purge -y
bash snapshot.sh | sort -u >"$work/after"
diff "$work/before" "$work/after" || fail "purging has left the system changed (> left behind, < missing)"
echo "$(wc -l <"$work/after") files and accounts, as before"

step "a token before the first start"
quietly apt-get install -y --no-install-recommends ./hedgehogd_*.deb ./hedgehog-tools_*.deb
quietly hedgehogctl token add arcade --role play
modes=$(stat --format '%a %U:%G %n' /var/lib/hedgehog /var/lib/hedgehog/tokens)
[ "$modes" = "750 hedgehog:hedgehog /var/lib/hedgehog
600 hedgehog:hedgehog /var/lib/hedgehog/tokens" ] || fail "$modes"
purge
left=$(ours)
[ -z "$left" ] || fail "left behind: $left"
