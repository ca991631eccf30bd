// SPDX-License-Identifier: MIT
// Repeated arming after the same trip backs off, and no current flows meanwhile.
#include "daemon/device/simulator/simulator_settings.h"
#include "tests/safety/safe.h"

namespace hedgehog::safety {
namespace {

using control::Reason;

/// Trips by an open sensor, which is repaired at once.
void trip(rig::Rig& rig) {
  rig.set_faults(device::kSimSensorOpen);
  rig.run(100);
  ASSERT_EQ(name(rig.controller().reason()), "sensor_open");
  rig.set_faults(0);
  rig.run(100);
}

TEST(RearmThroughTheSameTrip, WaitsFromTheFourthTimeOn) {
  rig::Rig rig;
  rig.run_until_armed();
  for (int times = 0; times < 3; ++times) {
    trip(rig);
    rig.arm();
    rig.run(100);
    ASSERT_EQ(name(rig.controller().state()), "armed") << times;
  }
  trip(rig);
  const auto since = rig.now() - rig.snapshot().since;
  EXPECT_EQ(name(rig.snapshot().arming_blocker), "sensor_open");
  EXPECT_EQ(rig.snapshot().rearm_wait, 10'000 - since);
  rig.start(rig::hold({1, 0, 0}, 5.0));
  for (int i = 0; i < 9; ++i) {
    rig.arm();
    rig.run(1000);
    ASSERT_EQ(name(rig.controller().state()), "tripped");
    ASSERT_EQ(rig.current_a(), 0.0);
  }
  rig.run(1000);
  rig.arm();
  rig.run(100);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

TEST(RearmThroughTheSameTrip, PersistsOverARestart) {
  rig::RigOptions options;
  options.control.latch = Reason::kSensorOpen;
  options.control.rearms[static_cast<std::size_t>(Reason::kSensorOpen)] = 4;
  rig::Rig rig(options);
  rig.run(1000);
  rig.arm();
  rig.run(18'000);
  EXPECT_EQ(name(rig.controller().state()), "tripped");
  rig.run(1100);
  rig.arm();
  rig.run(100);
  EXPECT_EQ(name(rig.controller().state()), "armed");
}

}  // namespace
}  // namespace hedgehog::safety
