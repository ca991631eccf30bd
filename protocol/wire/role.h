// SPDX-License-Identifier: MIT
// What a connection may do. Each role may do all that the ones before it may.
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
