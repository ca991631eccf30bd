#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh BUILD: tests config/monitoring with Debian's Prometheus and a simulated ball of that build. Exit: 0 passed.
set -euo pipefail

[ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
build=$(cd "$1" && pwd)
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
monitoring=$(cd "$here/../../config/monitoring" && pwd)
work=$(mktemp -d)
running=()
# shellcheck disable=SC2317  # called by the trap
clean_up() {
  [ ${#running[@]} -eq 0 ] || kill "${running[@]}" 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap clean_up EXIT
step() { echo "tests/monitoring: $*"; }

step "rules"
promtool check rules "$monitoring/hedgehog.rules.yml"
promtool test rules "$monitoring/hedgehog.rules.test.yml"

export XDG_RUNTIME_DIR=$work/run XDG_STATE_HOME=$work/state XDG_CONFIG_HOME=$work/config HOME=$work
unset HEDGEHOG_ADDRESS
mkdir -p "$work/run" "$work/config/hedgehog"
echo '{"http": {"listen": "127.0.0.1:0"}}' >"$work/config/hedgehog/hedgehogd.json"
mkfifo "$work/lines"
exec 3<>"$work/lines"

# said PATTERN: prints the text after PATTERN in the next line that contains it.
said() {
  local line
  while read -r -t 120 -u 3 line; do
    [[ $line != *"$1"* ]] || { printf '%s\n' "${line##*"$1"}"; return; }
  done
  echo "tests/monitoring: no line with $1" >&2
  return 1
}

"$build/daemon/hedgehogd" --simulate --speed 1 --listen 127.0.0.1:0 >"$work/lines" 2>"$work/daemon.log" &
running+=($!)
ball=$(said "listening on http://")

# A ball that other machines could reach.
mkdir -p "$work/remote/hedgehog"
echo '{"http": {"listen": "tls://127.0.0.1:0"}}' >"$work/remote/hedgehog/hedgehogd.json"
token() { "$build/clients/ctl/hedgehogctl" token "$@" --state "$work/remote/hedgehog"; }
token add prometheus --role observe 2>/dev/null | head -n 1 >"$work/hedgehog.token"
token certificate >/dev/null 2>&1
XDG_CONFIG_HOME=$work/remote XDG_STATE_HOME=$work/remote XDG_RUNTIME_DIR=$work/remote \
  "$build/daemon/hedgehogd" --simulate --speed 1 --listen 127.0.0.1:0 >"$work/lines" 2>"$work/remote.log" &
running+=($!)
remote=$(said "listening on https://")

# start_prometheus NAME [OPTION]...: of the configuration $work/NAME.yml; the next line with "Listening on" has its address.
start_prometheus() {
  local name=$1
  shift
  promtool check config "$work/$name.yml"
  prometheus --config.file="$work/$name.yml" --storage.tsdb.path="$work/$name" --web.listen-address=127.0.0.1:0 "$@" \
    >"$work/$name.log" 2>"$work/lines" &
  running+=($!)
}

echo 'global: { evaluation_interval: 1s }' >"$work/second.yml"
start_prometheus second --web.enable-remote-write-receiver
second=$(said 'msg="Listening on" address=')

# scrape.yml with its examples, which are comments there.
echo 'global: { evaluation_interval: 1s }' >"$work/first.yml"
sed -e "s|/usr/share/hedgehog/monitoring|$monitoring|; s|/etc/hedgehog/balls.json|$work/balls.json|; s|scrape_interval: 5s|scrape_interval: 1s|" \
  -e "/^#  - job_name:/,/replacement:/ s/^#//; s|/etc/prometheus/hedgehog.token|$work/hedgehog.token|" \
  -e "s|/etc/prometheus/ball-host.pem|$work/remote/hedgehog/certificate.pem|; s|ball-host:7587|$remote|" \
  -e "s|server_name: ball-host|server_name: $(hostname)|" \
  -e "/^#remote_write:/,\$ s/^#//; s|https://metrics.example:9090/|http://$second/|" \
  -e "s|/etc/prometheus/remote-write.password|$work/password|" "$monitoring/scrape.yml" >>"$work/first.yml"
grep -q '^remote_write:' "$work/first.yml"
echo secret >"$work/password"
sed -e "s|127.0.0.1:7587|$ball|" "$monitoring/balls.json" >"$work/balls.json"
start_prometheus first
prometheus=$(said 'msg="Listening on" address=')

step "Prometheus at $prometheus, a ball at $ball"
python3 "$here/queries.py" "$monitoring" "http://$prometheus" "$ball"
step "the same of a ball at https://$remote"
python3 "$here/queries.py" "$monitoring" "http://$prometheus" "$remote"
step "remote_write to a Prometheus at $second"
python3 "$here/remote_write.py" "$monitoring" "http://$prometheus" "http://$second" "$ball"
step "all is well"
