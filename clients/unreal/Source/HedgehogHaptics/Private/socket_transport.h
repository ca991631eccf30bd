// SPDX-License-Identifier: MIT
// A TCP connection over Unreal's own sockets, which every platform of the engine has.
#pragma once

#include "core/transport.h"

/// Connects on the game thread and never waits: names are looked up by a task of the engine's.
hedgehog::unreal::Connect HedgehogConnector();
