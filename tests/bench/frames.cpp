// SPDX-License-Identifier: MIT
// Cost for the link thread of a frame to the board and of one from it.
#include <benchmark/benchmark.h>

#include "daemon/device/board_codec.h"
#include "model/limit/thermal_limiter.h"

namespace hedgehog::device {
namespace {

void encode_set_point_frame(benchmark::State& state) {
  model::ThermalLimiter limiter;
  const auto command = BoardCommand::drive(limiter.limit({{1.0, 2.0, 3.0}}, {}), {0.45, 0.45, 0.45},
                                           1.5e-3, {}, 12.0);
  if (!command.enable()) state.SkipWithError("the safe command");
  std::uint32_t sequence = 0;
  for (auto _ : state) benchmark::DoNotOptimize(encode_set_point(command, ++sequence));
}
BENCHMARK(encode_set_point_frame);

void decode_telemetry_frame(benchmark::State& state) {
  Frame frame{};
  board::write_frame(board::TelemetryFrame{}, frame.data());
  for (auto _ : state) {
    const DecodedTelemetry decoded = decode_telemetry(frame);
    if (decoded.error != board::FrameError::kNone) state.SkipWithError("not a frame");
    benchmark::DoNotOptimize(decoded);
  }
}
BENCHMARK(decode_telemetry_frame);

}  // namespace
}  // namespace hedgehog::device
