// SPDX-License-Identifier: MIT
// SHA-256 digests as text. Any thread.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::base {

using Sha256 = std::array<unsigned char, 32>;

/// 64 lower-case hexadecimal digits.
std::string to_hex(const Sha256& digest);
/// The inverse; also accepts upper case and a colon after each pair. nullopt: anything else.
std::optional<Sha256> parse_sha256(std::string_view text);

}  // namespace hedgehog::base
