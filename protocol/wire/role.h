// SPDX-License-Identifier: MIT
// Permissions of a connection. Each role includes the previous ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace hedgehog::protocol {

enum class Role : std::uint8_t { kObserve, kPlay, kOperate };

/// "observe", "play", "operate".
std::string_view name(Role role) noexcept;
std::optional<Role> role_named(std::string_view text) noexcept;

}  // namespace hedgehog::protocol
