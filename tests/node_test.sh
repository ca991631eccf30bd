#!/bin/sh
# SPDX-License-Identifier: MIT
# node_test.sh TIMEOUT_MS ARG...: `node --test ARG...`, in which a file whose tests take longer than TIMEOUT_MS altogether fails.
# Node.js has that limit since 20.11; with an older one, like that of Debian 12, the run as a whole is ended (exit 124) after
# HEDGEHOG_NODE_TESTS (20) times as long.
set -eu

[ $# -ge 2 ] || { echo "node_test.sh TIMEOUT_MS ARG..." >&2; exit 64; }
timeout_ms=$1
shift
if node --help | grep -q -e --test-timeout; then
  exec node --test "--test-timeout=$timeout_ms" "$@"
fi
exec timeout --kill-after=10 "$((${HEDGEHOG_NODE_TESTS:-20} * timeout_ms / 1000))" node --test "$@"
