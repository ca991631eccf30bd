// SPDX-License-Identifier: MIT
// Orientation sensors and the second thermometer, as real USB devices. No board is needed.
#include <cmath>
#include <filesystem>
#include <string>

#include "model/quaternion.h"
#include "tests/vm/bench.h"

namespace hedgehog::vm {
namespace {

namespace fs = std::filesystem;

class Sensors : public Bench {
 protected:
  Sensors() : Bench(kEveryDevice) {}

  void turn(const std::string& device, const model::Quaternion& q) const {
    emulator_->ok("turn " + device + " " + std::to_string(q.w) + " " + std::to_string(q.x) + " " +
                  std::to_string(q.y) + " " + std::to_string(q.z));
  }
  /// True once the daemon reports the ball's up direction as `up`, within half a degree.
  static bool shows_up(Daemon& daemon, const model::Vec3& up) {
    return eventually([&] {
      const Json orientation = daemon.status()["orientation"];
      if (orientation.is_null() || orientation.value("age_ms", 1000) > 100) return false;
      double product = 0.0;
      for (int i = 0; i < 3; ++i)
        product += up[i] * orientation["up"][static_cast<std::size_t>(i)].get<double>();
      return product > std::cos(0.5 * 3.14159 / 180.0);
    });
  }
  static bool is_stale(Daemon& daemon) {
    return eventually([&] {
      const Json orientation = daemon.status()["orientation"];
      return orientation.is_null() || orientation.value("age_ms", 0) > 200;
    });
  }

  /// Reads `device` as imu.type `type`, rotates it, unplugs it, and plugs it in again.
  void expect_followed(const std::string& device, const std::string& type) {
    configure({{"imu", {{"type", type}}}});
    const model::Quaternion left = model::axis_angle({1, 0, 0}, -40.0);
    turn(device, left);
    emulator_->ok("plug " + device);
    Daemon daemon(home_);
    const double from = now_ms();
    EXPECT_TRUE(shows_up(daemon, rotate(conjugate(left), {0, 0, 1})))
        << daemon.log() << daemon.status();
    figure(type + ": start to the first right orientation", now_ms() - from, "ms");

    const int before = emulator_->status(device)["reports"];
    pause_ms(1000);
    figure(type + ": reports in 1 s", emulator_->status(device)["reports"].get<int>() - before, "");

    const model::Quaternion forward = model::axis_angle({0, 1, 0}, 30.0);
    turn(device, forward);
    EXPECT_TRUE(shows_up(daemon, rotate(conjugate(forward), {0, 0, 1}))) << daemon.status();

    emulator_->ok("unplug " + device);
    EXPECT_TRUE(is_stale(daemon)) << "it fades, it does not freeze";
    const double plugged = now_ms();
    emulator_->ok("plug " + device);
    EXPECT_TRUE(shows_up(daemon, rotate(conjugate(forward), {0, 0, 1}))) << daemon.log();
    figure(type + ": plug to orientation", now_ms() - plugged, "ms");
    EXPECT_EQ(daemon.stop(), 0);
  }

  /// The kernel driver of the HID device with these ids, "" if none; its hidraw node if it has one.
  struct Hid {
    std::string driver;
    bool hidraw = false;
  };
  static Hid hid(const std::string& ids) {
    Hid found;
    for (const auto& entry : fs::directory_iterator("/sys/bus/hid/devices")) {
      if (entry.path().filename().string().find(ids) == std::string::npos) continue;
      std::error_code error;
      found.driver = fs::read_symlink(entry.path() / "driver", error).filename().string();
      found.hidraw = fs::exists(entry.path() / "hidraw");
    }
    return found;
  }
};

TEST_F(Sensors, AnMtiIsConfiguredAndRead) {
  expect_followed("mti", "mti");
  EXPECT_EQ(emulator_->status("mti")["running"], true);
}

TEST_F(Sensors, ADualSenseIsReadBesideItsKernelDriver) {
  expect_followed("dualsense", "dualsense");
  EXPECT_EQ(hid(":054C:0CE6.").driver, "playstation") << "a pad stays a pad";
}

TEST_F(Sensors, AHidSensorIsDetachedFromTheKernelsHubAndReturned) {
  emulator_->ok("plug hid-sensor");
  ASSERT_TRUE(eventually([] { return hid(":1209:0002.").driver == "hid-sensor-hub"; }));
  figure("hid-sensor-hub leaves a hidraw node (1: yes)", hid(":1209:0002.").hidraw ? 1 : 0, "");
  emulator_->ok("unplug hid-sensor");
  ASSERT_TRUE(eventually([] { return hid(":1209:0002.").driver.empty(); }));

  expect_followed("hid-sensor", "hid_sensor");
  EXPECT_TRUE(eventually([] { return hid(":1209:0002.").driver == "hid-sensor-hub"; }))
      << "the daemon has gone, the kernel has its sensor again";
}

TEST_F(Sensors, ATemperStickIsASecondThermometer) {
  configure({{"thermometer", {{"type", "temper"}, {"role", "shell"}}}});
  emulator_->ok("temperature temper 31.5");
  emulator_->ok("plug temper");
  emulator_->ok("plug board");
  Daemon daemon(home_);
  EXPECT_TRUE(eventually([&] {
    const Json temperature = daemon.status()["temperature_c"];
    return temperature.contains("thermometer") &&
           temperature["thermometer"].dump().find("31.5") != std::string::npos;
  })) << daemon.status()
      << daemon.log();
}

}  // namespace
}  // namespace hedgehog::vm
