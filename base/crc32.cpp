// SPDX-License-Identifier: MIT
#include "base/crc32.h"

#include <boost/crc.hpp>

namespace hedgehog::base {

std::uint32_t crc32(std::span<const std::byte> bytes) noexcept {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

}  // namespace hedgehog::base
