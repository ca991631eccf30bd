// SPDX-License-Identifier: MIT
// A TCP connection over Unreal's sockets, available on every platform of the engine.
#pragma once

#include "core/transport.h"

/// Connects on the game thread without blocking: names are resolved by a task of the engine.
hedgehog::unreal::Connect HedgehogConnector();
