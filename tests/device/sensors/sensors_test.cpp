// SPDX-License-Identifier: MIT
// The sensors over fake ports: opening, switching on, publishing, unplugging.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "daemon/device/sensors/imu_sensors.h"
#include "daemon/device/sensors/sensor_thread.h"
#include "daemon/device/sensors/temper_sensor.h"
#include "tests/device/hex.h"
#include "tests/device/hid_examples.h"
#include "tests/device/imu/fake_mti.h"
#include "tests/device/sensors/fake_ports.h"

namespace hedgehog::device {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(HidSensorImu, IsSwitchedOnAndPublishesWithARateFromItsTurns) {
  Desk desk;
  FakeHid hid;
  hid.descriptor = short_orientation_descriptor();
  HidSensorImu imu(hid.opener(), desk.orientation());
  ASSERT_EQ(imu.open(), "");
  EXPECT_THAT(hid.features[5], ElementsAre(5, 2, 2, 10, 0, 0, 0));

  desk.now = 1000;
  hid.reports.push_back({5, 2, 4, 0, 0, 0, 0, 0, 0, 0xE8, 0x03});  // level
  hid.reports.push_back({4, 9, 9});                                // another report
  EXPECT_TRUE(imu.poll(0ms));
  EXPECT_TRUE(imu.poll(0ms));
  desk.now = 1100;
  hid.reports.push_back({5, 2, 4, 0, 0, 0, 0, 0x57, 0x00, 0xE4, 0x03});  // 10 degrees about up
  EXPECT_TRUE(imu.poll(0ms));
  EXPECT_TRUE(imu.poll(0ms)) << "nothing came";
  ASSERT_EQ(desk.samples.size(), 2u);
  EXPECT_EQ(desk.samples[0].stamp, 1000);
  EXPECT_TRUE(desk.samples[0].present);
  EXPECT_NEAR(desk.samples[1].rate_deg_s.z, 100.0, 1.0);
  EXPECT_NEAR(norm(desk.samples[1].rate_deg_s), 100.0, 1.0);

  hid.plugged = false;
  EXPECT_FALSE(imu.poll(0ms));
  imu.close();
  EXPECT_EQ(hid.open_ports, 0);
}

TEST(HidSensorImu, ADeviceWithoutOrientationIsNamed) {
  Desk desk;
  FakeHid mouse;
  mouse.descriptor = mouse_descriptor();
  HidSensorImu imu(mouse.opener(), desk.orientation());
  EXPECT_EQ(imu.open(), "Fake (1234:5678): its report descriptor has no orientation");
  EXPECT_EQ(mouse.open_ports, 0);
}

TEST(MtiImu, ConfiguresAndPublishes) {
  Desk desk;
  FakeMti mti;
  // Capture A of the protocol's test: 100 Hz of the same sample.
  const auto capture = from_hex(
      "FA FF 36 4E 10 60 04 02 53 35 CB 20 10 10 3F 7F FA 66 BB 40 34 B8 3C 49 96 2D 3B 5A 1F 82 "
      "80 20 0C 39 FF 91 01 BA EC DD 81 BA 86 53 80 40 20 0C BE 64 DB 99 BC E7 FF 83 41 1D C2 CF "
      "C0 20 0C BE 90 48 80 3F 67 32 04 BF 54 89 04 E0 20 04 00 00 00 03 C9");
  MtiImu imu(
      [&]() -> OpenedBytes {
        return {std::make_unique<FakeBytePort>([&](const std::vector<Byte>& sent) {
                  return sent.empty() && mti.measuring ? capture : mti.respond(sent);
                }),
                {},
                "MTi-30 (2639:0003)"};
      },
      desk.orientation());
  ASSERT_EQ(imu.open(), "");
  for (; desk.now < 1000; desk.now += 10) ASSERT_TRUE(imu.poll(0ms));
  ASSERT_GT(desk.samples.size(), 50u);
  EXPECT_NEAR(desk.samples.back().quaternion.w, 0.999915, 1e-5);
  EXPECT_NEAR(desk.samples.back().rate_deg_s.y, -0.001807 * 57.29578, 1e-4);
  EXPECT_EQ(desk.samples.back().stamp, 990);
}

/// A simulated TEMPer2.
struct FakeTemper : FakeHid {
  std::string firmware = "TEMPer2_V3.9    ";
  std::string temperature = "80 80 0A 8C 4E 20 00 00 80 01 0D DE 4E 20 00 00";
  int ignored_requests = 0;  // number of first requests without a response

  FakeTemper() {
    respond = [this](const std::vector<Byte>& out) -> std::vector<std::vector<Byte>> {
      if (ignored_requests > 0) {
        --ignored_requests;
        return {};
      }
      EXPECT_EQ(out.size(), 9u);
      EXPECT_EQ(out[0], 0);
      std::vector<Byte> bytes(firmware.begin(), firmware.end());
      if (out[2] == 0x80) bytes = from_hex(temperature);
      std::vector<std::vector<Byte>> replies;
      for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
        const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(i);
        replies.emplace_back(at, at + 8);
      }
      return replies;
    };
  }
};

TEST(TemperSensor, ReadsItsProbeTwiceASecond) {
  Desk desk;
  FakeTemper stick;
  stick.ignored_requests = 3;
  TemperSensor sensor(stick.opener(), desk.thermometer());
  ASSERT_EQ(sensor.open(), "");
  EXPECT_EQ(sensor.name(), "Fake (1234:5678), TEMPer2_V3.9");
  for (; desk.now < 2000; desk.now += 50) ASSERT_TRUE(sensor.poll(0ms));
  ASSERT_EQ(desk.readings.size(), 4u);
  EXPECT_EQ(desk.readings[0].celsius, 35.5) << "the probe, not the stick";
  EXPECT_EQ(desk.readings[1].stamp, 500);
}

TEST(TemperSensor, AnUnpluggedProbeGivesNoReading) {
  Desk desk;
  FakeTemper stick;
  stick.temperature = "80 80 0A 8C 4E 20 00 00 80 01 4E 20 4E 20 00 00";
  TemperSensor sensor(stick.opener(), desk.thermometer());
  ASSERT_EQ(sensor.open(), "");
  for (; desk.now < 2000; desk.now += 50) ASSERT_TRUE(sensor.poll(0ms));
  EXPECT_TRUE(desk.readings.empty());
}

TEST(TemperSensor, AnUnknownFirmwareIsNamed) {
  Desk desk;
  FakeTemper stick;
  stick.firmware = "TEMPerNew_V9    ";
  TemperSensor sensor(stick.opener(), desk.thermometer());
  EXPECT_THAT(sensor.open(), HasSubstr("\"TEMPerNew_V9\" is not supported"));
  EXPECT_EQ(stick.open_ports, 0);
}

/// Fails after a number of polls; counts the calls.
struct Flaky : Sensor {
  struct Log {
    std::atomic<int> opened{0}, closed{0}, polled{0};
    std::atomic<bool> there{true};
  };
  Log& log;
  int left = 0;
  std::chrono::steady_clock::time_point opened_at{};
  std::string label = "flaky";

  explicit Flaky(Log& l) : log(l) {}
  std::string open() override {
    if (!log.there) return "no flaky is connected";
    EXPECT_EQ(log.polled, 3 * log.opened) << "each opening is used up";
    EXPECT_EQ(log.closed, log.opened);
    const auto now = std::chrono::steady_clock::now();
    if (log.opened > 0) {
      EXPECT_GE(now - opened_at, SensorThread::kFirstPause)
          << "one that dies at once is not hammered";
    }
    opened_at = now;
    ++log.opened;
    left = 3;
    return {};
  }
  bool poll(std::chrono::milliseconds) override {
    ++log.polled;
    return log.there && --left > 0;
  }
  void close() override { ++log.closed; }
  const std::string& name() const override { return label; }
};

// False when `done` was not true within a minute.
template <class Done>
bool eventually(Done done) {
  const auto until = std::chrono::steady_clock::now() + 60s;
  while (!done() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(5ms);
  return done();
}

TEST(SensorThread, ReopensWithBackoffAndReportsWhy) {
  Flaky::Log log;
  {
    SensorThread thread(std::make_unique<Flaky>(log));
    ASSERT_TRUE(eventually([&] { return log.opened >= 2; }));
    log.there = false;
    ASSERT_TRUE(eventually([&] { return thread.state().what == "no flaky is connected"; }));
    EXPECT_FALSE(thread.state().open);
    EXPECT_EQ(thread.state().opened, static_cast<unsigned>(log.opened));
  }
}

TEST(Plugging, AThousandTimesLeavesNothingOpen) {
  Desk desk;
  FakeHid hid;
  hid.descriptor = long_orientation_descriptor();
  HidSensorImu imu(hid.opener(), desk.orientation());
  for (int i = 0; i < 1000; ++i) {
    hid.plugged = true;
    ASSERT_EQ(imu.open(), "");
    hid.reports.push_back(std::vector<Byte>(28, static_cast<Byte>(i)));
    ASSERT_TRUE(imu.poll(0ms));
    hid.plugged = false;
    ASSERT_FALSE(imu.poll(0ms));
    imu.close();
    ASSERT_EQ(hid.open_ports, 0);
    ASSERT_EQ(imu.open(), "no fake is connected");
  }
  EXPECT_EQ(hid.opened, 1000);
}

}  // namespace
}  // namespace hedgehog::device
