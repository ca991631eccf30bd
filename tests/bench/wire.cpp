// SPDX-License-Identifier: MIT
// Cost of decoding a request line into values, and of encoding values into the response line.
#include <benchmark/benchmark.h>

#include <string>

#include "protocol/server_codec.h"

namespace hedgehog::protocol {
namespace {

void decode(benchmark::State& state, const std::string& line) {
  for (auto _ : state) {
    Incoming incoming = decode_line(line);
    if (incoming.items.front().request.has_error()) state.SkipWithError("not a request");
    benchmark::DoNotOptimize(incoming);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(line.size()));
}
BENCHMARK_CAPTURE(decode, ping, R"({"jsonrpc":"2.0","id":1,"method":"ping"})");
BENCHMARK_CAPTURE(decode, pulse,
                  R"({"jsonrpc":"2.0","id":412,"method":"effect.pulse",)"
                  R"("params":{"direction":[0.2,-0.9,0.1],"level":0.6,"duration_ms":180}})");
BENCHMARK_CAPTURE(decode, vibrate_in_slot,
                  R"({"jsonrpc":"2.0","method":"effect.vibrate","params":{"slot":"engine",)"
                  R"("level":0.31,"frequency_hz":72.5,"waveform":"sine","lease_ms":250}})");

/// Status of a ball with four effects.
Status busy_status() {
  Status status;
  status.time_ns = 273'660'123'456'789;
  status.current_a = {0.0, 4.99, 0.12};
  for (int i = 0; i < 4; ++i) status.effects.emplace_back();
  return status;
}

template <class Result>
void encode(benchmark::State& state, const Result& result) {
  const Id id = Id::number(412);
  for (auto _ : state) benchmark::DoNotOptimize(encode_result(id, result));
}
BENCHMARK_CAPTURE(encode, ping, PingResult{273'660'123'456'789});
BENCHMARK_CAPTURE(encode, admission, Admission{});
BENCHMARK_CAPTURE(encode, status, busy_status());

void encode_telemetry_line(benchmark::State& state) {
  const Telemetry telemetry{.status = busy_status()};
  for (auto _ : state) benchmark::DoNotOptimize(encode_telemetry(telemetry));
}
BENCHMARK(encode_telemetry_line);

}  // namespace
}  // namespace hedgehog::protocol
