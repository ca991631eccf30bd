// SPDX-License-Identifier: MIT
// The control thread is late or blocked, alone or together with the link.
#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::EventType;
using control::Reason;

TEST(ControlLate, TheLinkIsSafeAfterTwentyMilliseconds) {
  rig::Rig rig;
  hold_five_ampere(rig);
  rig.skip_control(19);
  EXPECT_FALSE(asleep(rig));
  rig.skip_control(1);
  EXPECT_TRUE(asleep(rig));
  rig.skip_control(kDecay);
  EXPECT_LT(rig.current_a(), kZeroA);
  // It resumes with one tick, not with a burst, and reports the skipped ticks.
  rig.clear_events();
  rig.tick();
  EXPECT_EQ(rig.last_inputs().skipped, 20u + kDecay);
  ASSERT_EQ(rig.count(EventType::kOverrun), 1);
  EXPECT_EQ(rig.last(EventType::kOverrun)->count, 20u + kDecay);
  rig.run(100);
  EXPECT_EQ(name(rig.controller().state()), "armed") << "being late is no fault of the ball";
  EXPECT_NEAR(rig.current_a(), 5.0, 0.05);
}

// The link runs in every tenth tick only; its repeated set-points reset the dead-man meanwhile.
TEST(ControlLate, ALinkThatIsLateTooCountsMillisecondsNotSteps) {
  rig::Rig rig;
  hold_five_ampere(rig);
  const auto link_at_the_tenth = [&] {
    rig.freeze_host(9);
    rig.skip_control(1);
  };
  link_at_the_tenth();
  EXPECT_FALSE(asleep(rig));
  link_at_the_tenth();
  EXPECT_TRUE(asleep(rig)) << "20 ms";
  rig.freeze_host(kDecay);
  EXPECT_LT(rig.current_a(), kZeroA);
  EXPECT_EQ(rig.link().report().counters.overdue, 1u);
}

// A control thread that runs in every tenth tick only: fault durations are still counted in
// milliseconds.
TEST(ControlLate, FaultsAreTimedByTheClockAndNotByTheStep) {
  rig::RigOptions options;
  options.board.start_c = 45.0;  // so that the fan is required
  rig::Rig rig(options);
  rig.run_until_armed();
  rig.set_faults(device::kSimFanStopped);
  const model::Tick from = rig.now();
  rig.run(50);
  while (rig.now() - from < 6000 && rig.controller().state() == control::State::kArmed) {
    rig.skip_control(9);
    rig.tick();
  }
  expect_tripped(rig, Reason::kFanStopped);
  EXPECT_GE(rig.now() - from, 3000);
  EXPECT_LE(rig.now() - from, 3300);
}

TEST(ControlLate, AGapThatTheBoardPlayedThroughIsNoWrongCurrent) {
  rig::Rig rig;
  rig.run_until_armed();
  rig.start(rig::hold({1, 0, 0}, 8.0));
  rig.run(100);
  for (const model::Tick gap : {5, 15, 30, 60, 98}) {
    rig.freeze_host(gap);  // the board holds the last set-point
    rig.run(200);
    ASSERT_EQ(name(rig.controller().state()), "armed") << gap;
    rig.skip_control(gap);  // the link sends the safe command after 20 ms
    rig.run(200);
    ASSERT_EQ(name(rig.controller().state()), "armed") << gap;
  }
}

}  // namespace
}  // namespace hedgehog::safety
