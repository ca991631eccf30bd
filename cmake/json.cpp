// SPDX-License-Identifier: MIT
// Owns the precompiled nlohmann/json header of the layers that decode but do no networking.

#include <nlohmann/json.hpp>
