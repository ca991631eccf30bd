// SPDX-License-Identifier: MIT
#include "base/digest_text.h"

#include <cstddef>

namespace hedgehog::base {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

int value_of(char digit) noexcept {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
  return -1;
}

}  // namespace

std::string to_hex(const Sha256& digest) {
  std::string text;
  text.reserve(2 * digest.size());
  for (const unsigned char byte : digest) {
    text += kHexDigits[byte >> 4];
    text += kHexDigits[byte & 15];
  }
  return text;
}

std::optional<Sha256> parse_sha256(std::string_view text) {
  Sha256 digest{};
  const bool colons = text.size() == 3 * digest.size() - 1;
  if (!colons && text.size() != 2 * digest.size()) return std::nullopt;
  const std::size_t step = colons ? 3 : 2;
  for (std::size_t i = 0; i < digest.size(); ++i) {
    const int high = value_of(text[i * step]);
    const int low = value_of(text[i * step + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    if (colons && i > 0 && text[i * step - 1] != ':') return std::nullopt;
    digest[i] = static_cast<unsigned char>(high * 16 + low);
  }
  return digest;
}

}  // namespace hedgehog::base
