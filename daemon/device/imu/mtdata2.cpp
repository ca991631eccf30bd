// SPDX-License-Identifier: MIT
#include "daemon/device/imu/mtdata2.h"

#include <array>
#include <cmath>

namespace hedgehog::device {
namespace {

constexpr std::uint16_t kIdMask = 0xFFF0;
constexpr std::uint16_t kFormatMask = 0x3;
constexpr std::uint16_t kFrameMask = 0xC;
constexpr std::uint16_t kNed = 0x4;
constexpr std::uint16_t kWithEveryPacket = 0xFFFF;
// Larger rates or accelerations are implausible for a tracker: the number is corrupt.
constexpr double kMaxPlausible = 1e4;

constexpr std::array<std::size_t, 4> kNumberSize{4, 4, 6, 8};

double number(const Byte* at, unsigned format) noexcept {
  switch (format) {
    case 0:
      return big_f32(at);
    case 1:  // fixed point 12.20
      return static_cast<std::int32_t>(big_u32(at)) * 0x1.0p-20;
    case 2:  // fixed point 16.32: fraction first, then the integer part
      return big_i16(at + 4) + big_u32(at) * 0x1.0p-32;
    default:
      return big_f64(at);
  }
}

template <std::size_t n>
std::optional<std::array<double, n>> numbers(std::uint16_t id, std::span<const Byte> data) {
  const unsigned format = id & kFormatMask;
  if (data.size() != n * kNumberSize[format]) return std::nullopt;
  std::array<double, n> values{};
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = number(&data[i * kNumberSize[format]], format);
    if (!(std::abs(values[i]) < kMaxPlausible)) return std::nullopt;
  }
  return values;
}

std::optional<model::Vec3> vector(std::uint16_t id, std::span<const Byte> data) {
  const auto v = numbers<3>(id, data);
  if (!v) return std::nullopt;
  return model::Vec3{(*v)[0], (*v)[1], (*v)[2]};
}

std::optional<model::Quaternion> quaternion(std::uint16_t id, std::span<const Byte> data) {
  const auto v = numbers<4>(id, data);
  if (!v) return std::nullopt;
  model::Quaternion q{(*v)[0], (*v)[1], (*v)[2], (*v)[3]};
  const double length = norm(q);
  if (!(std::abs(length - 1.0) < 0.05)) return std::nullopt;
  q = {q.w / length, q.x / length, q.y / length, q.z / length};
  // North, east, down -> north, west, up: half a turn about north.
  return (id & kFrameMask) == kNed ? model::Quaternion{0, 1, 0, 0} * q : q;
}

void take(std::uint16_t id, std::span<const Byte> data, MtSample& sample) {
  switch (static_cast<MtDataId>(id & kIdMask)) {
    case MtDataId::kPacketCounter:
      if (data.size() == 2) sample.packet_counter = big_u16(data.data());
      break;
    case MtDataId::kSampleTimeFine:
      if (data.size() == 4) sample.sample_time = big_u32(data.data());
      break;
    case MtDataId::kQuaternion:
      sample.quaternion = quaternion(id, data);
      break;
    case MtDataId::kEulerAngles:
      sample.euler_deg = vector(id, data);
      break;
    case MtDataId::kAcceleration:
      sample.acceleration_m_s2 = vector(id, data);
      break;
    case MtDataId::kRateOfTurn:
    case MtDataId::kRateOfTurnHr:
      sample.rate_rad_s = vector(id, data);
      break;
    case MtDataId::kStatusWord:
      if (data.size() == 4) sample.status = big_u32(data.data());
      break;
  }
}

}  // namespace

std::optional<MtSample> decode_mtdata2(std::span<const Byte> payload) {
  MtSample sample;
  while (!payload.empty()) {
    if (payload.size() < 3) return std::nullopt;
    const std::size_t length = payload[2];
    if (payload.size() < 3 + length) return std::nullopt;
    take(big_u16(payload.data()), payload.subspan(3, length), sample);
    payload = payload.subspan(3 + length);
  }
  return sample;
}

std::vector<MtOutput> orientation_outputs(std::uint16_t rate_hz) {
  const auto output = [](MtDataId id, std::uint16_t rate) {
    return MtOutput{static_cast<std::uint16_t>(id), rate};
  };
  return {output(MtDataId::kPacketCounter, kWithEveryPacket),
          output(MtDataId::kSampleTimeFine, kWithEveryPacket),
          output(MtDataId::kQuaternion, rate_hz), output(MtDataId::kRateOfTurn, rate_hz),
          output(MtDataId::kStatusWord, kWithEveryPacket)};
}

std::vector<Byte> encode_outputs(std::span<const MtOutput> outputs) {
  std::vector<Byte> bytes;
  for (const MtOutput& output : outputs) {
    for (const std::uint16_t value : {output.id, output.rate_hz}) {
      bytes.push_back(static_cast<Byte>(value >> 8));
      bytes.push_back(static_cast<Byte>(value));
    }
  }
  return bytes;
}

std::optional<std::vector<MtOutput>> decode_outputs(std::span<const Byte> payload) {
  if (payload.size() % 4 != 0) return std::nullopt;
  std::vector<MtOutput> outputs;
  for (; !payload.empty(); payload = payload.subspan(4))
    outputs.push_back({big_u16(payload.data()), big_u16(payload.data() + 2)});
  return outputs;
}

}  // namespace hedgehog::device
