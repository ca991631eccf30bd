// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
#pragma once

#include "core/json.h"
#include "hedgehog_event.h"
#include "hedgehog_status.h"

namespace hedgehog::unreal {

void Read(const Json& Value, FHedgehogEvent& Message);
void Read(const Json& Value, FHedgehogStatus& Message);

}  // namespace hedgehog::unreal
