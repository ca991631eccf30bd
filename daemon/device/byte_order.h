// SPDX-License-Identifier: MIT
// Numbers from the bytes of devices. Pure functions; the caller has checked the length.
#pragma once

#include <bit>
#include <cstdint>

namespace hedgehog::device {

using Byte = std::uint8_t;

constexpr std::uint16_t big_u16(const Byte* at) noexcept {
  return static_cast<std::uint16_t>(at[0] << 8 | at[1]);
}
constexpr std::uint32_t big_u32(const Byte* at) noexcept {
  return std::uint32_t{big_u16(at)} << 16 | big_u16(at + 2);
}
constexpr std::uint64_t big_u64(const Byte* at) noexcept {
  return std::uint64_t{big_u32(at)} << 32 | big_u32(at + 4);
}
constexpr std::int16_t big_i16(const Byte* at) noexcept {
  return static_cast<std::int16_t>(big_u16(at));
}
inline float big_f32(const Byte* at) noexcept { return std::bit_cast<float>(big_u32(at)); }
inline double big_f64(const Byte* at) noexcept { return std::bit_cast<double>(big_u64(at)); }

constexpr std::uint16_t little_u16(const Byte* at) noexcept {
  return static_cast<std::uint16_t>(at[1] << 8 | at[0]);
}
constexpr std::int16_t little_i16(const Byte* at) noexcept {
  return static_cast<std::int16_t>(little_u16(at));
}
constexpr std::uint32_t little_u32(const Byte* at) noexcept {
  return std::uint32_t{little_u16(at + 2)} << 16 | little_u16(at);
}

}  // namespace hedgehog::device
