// SPDX-License-Identifier: MIT
// Arbitrary bytes from an Xsens tracker, in pieces. Every decoded message encodes to bytes that
// decode to it again; every sample has plausible numbers.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "daemon/device/imu/mti_session.h"

namespace {

using namespace hedgehog::device;

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const MtSample& sample) {
  if (sample.quaternion) require(std::abs(norm(*sample.quaternion) - 1.0) < 1e-9);
  for (const auto& v : {sample.euler_deg, sample.acceleration_m_s2, sample.rate_rad_s})
    require(!v || is_finite(*v));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const Byte* data, std::size_t size) {
  const std::span<const Byte> bytes(data, size);
  XbusParser parser;
  parser.feed(bytes);
  while (const auto message = parser.next()) {
    const auto again = encode_xbus(message->id, message->payload);
    XbusParser second;
    second.feed(again);
    require(second.next() == message);
    if (const auto outputs = decode_outputs(message->payload))
      require(encode_outputs(*outputs) == message->payload);
    if (const auto sample = decode_mtdata2(message->payload)) check(*sample);
  }
  if (const auto sample = decode_mtdata2(bytes)) check(*sample);
  // As from a tracker in the middle of a session.
  MtiSession session;
  double now_s = 0.0;
  for (std::size_t at = 0; at < size; at += 32) {
    (void)session.due(now_s);
    session.receive(bytes.subspan(at, std::min<std::size_t>(32, size - at)), now_s);
    now_s += 0.1;
  }
  while (const auto sample = session.next()) check(*sample);
  return 0;
}
