#!/bin/sh
# SPDX-License-Identifier: MIT
# run.sh BUILD: tests hedgehogd of that build with third-party JSON-RPC clients and JSON documents. Exit: 0 all passed.
set -eu

[ $# -eq 1 ] || { echo "run.sh BUILD" >&2; exit 64; }
build=$(cd -- "$1" && pwd)
here=$(cd -- "$(dirname -- "$0")" && pwd)
packages=$(cd -- "$here/../.." && pwd)/build/npm/json_rpc

"$here/../../cmake/npm.sh" "$here" "$packages"
HEDGEHOGD=$build/daemon/hedgehogd
HEDGEHOG_NODE_MODULES=$packages/node_modules
HEDGEHOG_JSON_READERS=$build/tests/json_rpc/json_readers
HEDGEHOG_JSONRPCCPP_CLIENT=$packages/jsonrpccpp_client
export HEDGEHOGD HEDGEHOG_NODE_MODULES HEDGEHOG_JSON_READERS HEDGEHOG_JSONRPCCPP_CLIENT

# shellcheck disable=SC2046  # flags are words
"${CXX:-c++}" -std=c++14 -Wall -Wextra -Wno-deprecated "$here/jsonrpccpp_client.cpp" -o "$HEDGEHOG_JSONRPCCPP_CLIENT" \
  $(pkg-config --cflags --libs jsoncpp libjsonrpccpp-client)

exec "$here/../node_test.sh" 240000 --test-concurrency=1 "$here"/*.test.mjs
