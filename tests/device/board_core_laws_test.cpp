// SPDX-License-Identifier: MIT
// Properties that hold for any frames in any order.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "tests/device/core_bench.h"

namespace hedgehog::board {
namespace {

enum class Action : std::uint8_t {
  kFeed,
  kFeedDisabled,
  kArm,
  kRepeat,
  kOld,
  kGarbage,
  kFlipped,
  kLimits,
  kNothing,
  kSilence,
  kFault,
};

struct Play {
  CoreBench bench;
  bool fresh_set_point = false;
  bool arm_with_new_count = false;
  int since_set_point_ms = 1'000'000;
  bool latched = false;

  void act(Action what, std::uint32_t noise) {
    std::array<std::uint8_t, kFrameSize> frame{};
    switch (what) {
      case Action::kFeed:
      case Action::kFeedDisabled:
        bench.set_point.enable = what == Action::kFeed;
        bench.set_point.duty_q15[noise % 3] = static_cast<std::int16_t>(noise);
        bench.feed();
        fresh_set_point = true;
        break;
      case Action::kArm:
        bench.request_arm();
        arm_with_new_count = true;
        break;
      case Action::kRepeat:
      case Action::kOld:
        bench.set_point.sequence = bench.sequence - (what == Action::kOld ? noise % 1000 : 0);
        write_frame(bench.set_point, frame.data());
        // Before the first set-point any sequence number is valid.
        if (bench.sequence == 0) break;
        bench.core.receive(frame.data(), frame.size());
        break;
      case Action::kGarbage:
        for (std::uint8_t& byte : frame)
          byte = static_cast<std::uint8_t>(noise = noise * 69069 + 1);
        bench.core.receive(frame.data(), noise % (kFrameSize + 1));
        break;
      case Action::kFlipped:
        bench.set_point.sequence = bench.sequence + 1;
        write_frame(bench.set_point, frame.data());
        frame[noise % kFrameSize] ^= static_cast<std::uint8_t>(1u << (noise >> 8) % 8);
        bench.core.receive(frame.data(), frame.size());
        break;
      case Action::kLimits:
        bench.send(LimitsFrame{0, 7000, 16000, 900});
        break;
      case Action::kFault:
        bench.inputs.bridge_faults ^= 1;
        break;
      case Action::kNothing:
      case Action::kSilence:
        break;
    }
  }

  void step() {
    since_set_point_ms = fresh_set_point ? 0 : since_set_point_ms + 1;
    const bool was_latched = bench.core.mode() == Mode::kLatched;
    bench.step();
    latched = was_latched && !arm_with_new_count;
    fresh_set_point = arm_with_new_count = false;
  }
};

RC_GTEST_PROP(BoardCoreLaws, NeverDrivesWithoutSetPointsOrLatchedOrPartlyAsleep, ()) {
  const auto actions = *rc::gen::container<std::vector<std::pair<Action, std::uint32_t>>>(
      rc::gen::pair(rc::gen::weightedElement<Action>({{12, Action::kFeed},
                                                      {2, Action::kFeedDisabled},
                                                      {4, Action::kArm},
                                                      {2, Action::kRepeat},
                                                      {2, Action::kOld},
                                                      {2, Action::kGarbage},
                                                      {2, Action::kFlipped},
                                                      {1, Action::kLimits},
                                                      {4, Action::kNothing},
                                                      {2, Action::kSilence},
                                                      {1, Action::kFault}}),
                    rc::gen::arbitrary<std::uint32_t>()));
  Play play;
  bool drove = false;
  for (const auto& [what, noise] : actions) {
    play.act(what, noise);
    const int ms = what == Action::kSilence ? static_cast<int>(noise % 250) : 1;
    for (int i = 0; i < ms; ++i) {
      play.step();
      const CoreBench& bench = play.bench;
      drove |= bench.drives();
      if (play.since_set_point_ms >= 100) RC_ASSERT(!bench.drives());
      if (play.latched) RC_ASSERT(!bench.drives());
      if (bench.core.mode() == Mode::kLatched) RC_ASSERT(bench.outputs.fan == 255);
      RC_ASSERT((bench.core.faults() != 0) == (bench.core.mode() == Mode::kLatched));
      const bool duty = bench.outputs.duty_q15[0] != 0 || bench.outputs.duty_q15[1] != 0 ||
                        bench.outputs.duty_q15[2] != 0;
      RC_ASSERT(!duty || bench.outputs.awake);
      RC_ASSERT(bench.outputs.awake == (bench.core.mode() == Mode::kDriving));
    }
  }
  RC_CLASSIFY(drove, "drove at some time");
}

RC_GTEST_PROP(BoardCoreLaws, RandomPacketsDoNothing,
              (const std::vector<std::vector<std::uint8_t>>& packets)) {
  CoreBench bench;
  bench.arm_and_drive();
  bench.feeding = false;
  for (const std::vector<std::uint8_t>& packet : packets)
    bench.core.receive(packet.data(), packet.size());
  bench.run(100);
  RC_ASSERT(bench.latched_by(kDeadMan));
  RC_ASSERT(bench.telemetry().refused == packets.size());
}

}  // namespace
}  // namespace hedgehog::board
