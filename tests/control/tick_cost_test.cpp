// SPDX-License-Identifier: MIT
// A tick, with recorder and mailbox, allocates nothing and takes no lock, for any request.
#include <gtest/gtest.h>

#include <memory>
#include <mutex>

#include "daemon/control/loop/control_tick.h"
#include "daemon/device/simulator/lock_step.h"
#include "tests/rig/allocation_guard.h"
#include "tests/rig/random_requests.h"
#include "tests/rig/rig.h"

namespace hedgehog::control {
namespace {

class TickCost : public testing::Test {
 protected:
  void SetUp() override {
    if (!rig::can_count_allocations()) GTEST_SKIP() << "the sanitizer has its own malloc";
  }

  void push(const decltype(Command::what)& what) { mailbox_->commands.push({++seq_, what}); }

  /// Every kind of request, with random places and times.
  void send_requests(model::Tick tick) {
    if (tick % 7 == 0) {
      const auto place = static_cast<std::uint8_t>(random_.bits() % kMaxEffects);
      mailbox_->stops.request(effects_[place], place, EndReason::kReplaced);
      StartEffect start{++last_effect_, place, effects_[place], place, {}};
      start.spec = rig::random_effect(random_, temper_);
      if (tick % 3 == 0) {
        start.spec.trajectory.path = model::Path::kKeyframes;
        start.spec.trajectory.playback = {
            .first = place, .count = 11, .length_ms = 500, .turn = {}};
        LoadKeyframes load{.first = place, .count = 11, .frames = {}};
        for (std::size_t i = 0; i < load.frames.size(); ++i) {
          load.frames[i].level = static_cast<float>(i) / 11.0F;
          load.frames[i].t_ms = static_cast<std::uint16_t>(50 * i);
        }
        push(load);
      }
      start.spec.frame = random_.bits() % 3 == 0 ? model::Frame::kWorld : model::Frame::kDevice;
      effects_[place] = start.effect;
      push(start);
      push(UpdateEffect{start.effect, place, start.spec});
    }
    if (tick % 50 == 0) push(Recenter{random_.uniform(-180.0, 180.0)});
    if (tick % 70 == 0) push(SetGain{random_.uniform(0.0, 1.0)});
    if (tick % 90 == 0) push(SetLimits{});
    if (tick % 900 == 0) mailbox_->emergency_generation.fetch_add(1);
    if (tick % 900 == 200) push(Arm{mailbox_->emergency_generation.load()});
    if (tick % 10 == 0) mailbox_->orientation.write({true, {}, {}, tick});
  }

  std::unique_ptr<Mailbox> mailbox_ = std::make_unique<Mailbox>();
  std::unique_ptr<device::LinkPort> port_ = std::make_unique<device::LinkPort>();
  FlightRecorder recorder_;
  ControlTick control_{rig::RigOptions::armed_at_start(), *mailbox_, *port_, &recorder_};
  device::LockStep world_{*port_};
  model::RandomStream random_{5};
  rig::Temper temper_;
  std::array<EffectId, kMaxEffects> effects_{};
  EffectId last_effect_ = 0;
  std::uint64_t seq_ = 0;
};

TEST_F(TickCost, NoAllocationAndNoLock) {
  const std::uint64_t at_first = rig::allocations() + rig::locks();
  const auto allocated = std::make_unique<std::array<int, 100>>();
  std::mutex mutex;
  { const std::lock_guard held(mutex); }
  ASSERT_EQ(rig::allocations() + rig::locks(), at_first + 2) << "the guard counts";

  std::uint64_t allocations = 0;
  std::uint64_t locks = 0;
  bool armed = false;
  bool tripped = false;
  Event event;
  for (model::Tick tick = 1; tick < 6000; ++tick) {
    send_requests(tick);
    if (tick == 5800) world_.board().apply({25.0, device::kSimSensorOpen, 0, {}});
    const std::uint64_t allocations_before = rig::allocations();
    const std::uint64_t locks_before = rig::locks();
    control_.run(tick, tick % 100 == 0 ? 3 : 0, {});
    allocations += rig::allocations() - allocations_before;
    locks += rig::locks() - locks_before;
    world_.step();
    while (mailbox_->events.pop(event)) {
    }
    const State state = mailbox_->status.read().state;
    armed = armed || state == State::kArmed;
    tripped = tripped || state == State::kTripped;
  }
  EXPECT_EQ(allocations, 0u);
  EXPECT_EQ(locks, 0u);
  EXPECT_TRUE(armed);
  EXPECT_TRUE(tripped) << "the way of a trip was walked too";
  EXPECT_TRUE(recorder_.frozen());
}

}  // namespace
}  // namespace hedgehog::control
