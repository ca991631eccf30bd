// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
#pragma once

#include "core/json.h"
#include "hedgehog_effect.h"

/// What is given of it, as the protocol has it.
hedgehog::unreal::Json HedgehogToJson(const FHedgehogEffect& Effect);
/// What is given of it, as the protocol has it.
hedgehog::unreal::Json HedgehogToJson(const FHedgehogCircle& Effect);
/// What is given of it, as the protocol has it.
hedgehog::unreal::Json HedgehogToJson(const FHedgehogPlay& Effect);
