// SPDX-License-Identifier: MIT
// Bytes from hexadecimal text.
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace hedgehog::device {

/// "FA FF 00" -> {0xFA, 0xFF, 0x00}.
inline std::vector<std::uint8_t> from_hex(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::uint8_t> bytes;
  for (unsigned byte = 0; words >> std::hex >> byte;)
    bytes.push_back(static_cast<std::uint8_t>(byte));
  return bytes;
}

}  // namespace hedgehog::device
