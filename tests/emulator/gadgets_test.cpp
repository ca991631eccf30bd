// SPDX-License-Identifier: MIT
// The emulated devices as seen by their host, against the daemon's own codecs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "daemon/device/imu/hid_orientation.h"
#include "daemon/device/imu/mti_session.h"
#include "daemon/device/imu/sony_pad.h"
#include "daemon/device/thermometer/temper.h"
#include "emulator/board_gadget.h"
#include "emulator/imu_gadgets.h"
#include "emulator/temper_gadget.h"
#include "emulator/words.h"
#include "tests/emulator/fake_host.h"

namespace hedgehog::emulator {
namespace {

using device::Frame;

Bytes bytes_of(const Frame& frame) { return {frame.begin(), frame.end()}; }

std::string execute(Gadget& gadget, const std::string& line) {
  return gadget.command(split(line, ' ')).value_or("unknown");
}

class Board : public testing::Test {
 protected:
  /// Exchanges a set-point and a telemetry frame in each of `milliseconds`.
  device::BoardTelemetry run(int milliseconds, double duty_x) {
    device::BoardTelemetry last;
    for (int i = 0; i < milliseconds; ++i) {
      board::SetPointFrame set_point;
      set_point.sequence = ++sequence_;
      set_point.enable = duty_x != 0.0;
      set_point.duty_q15[0] = static_cast<std::int16_t>(32767 * duty_x);
      Frame frame;
      board::write_frame(set_point, frame.data());
      EXPECT_EQ(host_.write(1, bytes_of(frame)).status, 0);
      if (const auto telemetry = host_.read(1))
        last = device::decode_telemetry(telemetry->data).telemetry;
    }
    return last;
  }
  void arm() { host_.write(1, bytes_of(device::encode_arm(1, ++sequence_))); }

  BoardGadget board_{BoardSettings{}};
  FakeHost host_{board_};
  std::uint32_t sequence_ = 0;
};

TEST_F(Board, HasItsDescriptors) {
  const Bytes descriptor = host_.control_in(0x80, 6, 0x0100, 0, 18).data;
  ASSERT_EQ(descriptor.size(), 18U);
  EXPECT_EQ(device::little_u16(&descriptor[8]), 0x1209);
  EXPECT_EQ(device::little_u16(&descriptor[10]), 0x0001);
  const Bytes name = host_.control_in(0x80, 6, 0x0302, 0x0409, 255).data;
  ASSERT_EQ(name.size(), 2 + 2 * std::string("Hedgehog driver board").size());
  EXPECT_EQ(name[2], 'H');

  const Bytes configuration = host_.control_in(0x80, 6, 0x0200, 0, 255).data;
  ASSERT_EQ(configuration.size(), 9U + 9 + 7 + 7);
  EXPECT_EQ(device::little_u16(&configuration[2]), configuration.size());
  EXPECT_THAT((Bytes(configuration.begin() + 14, configuration.begin() + 17)),
              testing::ElementsAre(0xFF, 0x48, 0x01));
  EXPECT_EQ(host_.control_in(0x80, 6, 0x0200, 0, 9).data.size(), 9U) << "no more than is asked for";
}

TEST_F(Board, IsArmedAndDrivenByFramesAndSafeAfterTheyEnd) {
  run(20, 0.0);
  arm();
  const auto driven = run(60, 0.2);
  EXPECT_EQ(driven.mode, device::BoardMode::kDriving);
  EXPECT_NEAR(driven.current_a[0], 0.2 * 12.0 / 0.45, 0.3);

  // The cable is unplugged; the board continues by itself.
  for (int i = 0; i < 99 + 20; ++i) board_.step();
  EXPECT_THAT(board_.status(), testing::HasSubstr(R"("mode": "latched")"));
  EXPECT_THAT(board_.status(), testing::HasSubstr(R"("peak_a": 0.0)"));
}

TEST_F(Board, DropsFramesThatTheHostDidNotReadInTime) {
  host_.run(10);
  EXPECT_THAT(board_.status(), testing::HasSubstr(R"("frames_out": 10, "frames_lost": 6)"));
}

TEST_F(Board, StallsUntilTheHostHasClearedItTheRequestedNumberOfTimes) {
  board_.halt(0x81, 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(host_.read(1)->status, kTransferStalled);
    EXPECT_EQ(host_.read(1)->status, kTransferStalled);
    EXPECT_EQ(host_.control_in(0x82, 0, 0, 0x81, 2).data[0], 1);
    EXPECT_EQ(host_.control_out(0x02, 1, 0, 0x81).status, 0);
  }
  EXPECT_EQ(host_.read(1)->status, 0);
  board_.halt(0x01, 1);
  EXPECT_EQ(host_.write(1, Bytes(64)).status, kTransferStalled);
}

TEST_F(Board, SilentItTransfersNothingUntilTheHostTimesOut) {
  board_.set_silent(true);
  const std::uint32_t read = host_.submit(true, 1, 64);
  const std::uint32_t write = host_.submit(false, 1, 64, Bytes(64));
  host_.run(50);
  EXPECT_FALSE(host_.next(true));
  for (const std::uint32_t waiting : {read, write}) {
    const std::uint32_t unlinked = host_.unlink(waiting);
    const auto done = host_.next();
    ASSERT_TRUE(done);
    EXPECT_EQ(done->command, 4U);
    EXPECT_EQ(done->sequence, unlinked);
    EXPECT_EQ(done->status, kTransferUnlinked);
  }
  host_.unlink(12345);
  EXPECT_EQ(host_.next()->status, 0) << "there was nothing to take back";
}

TEST_F(Board, OfAnotherVersionRefusesThisOne) {
  EXPECT_EQ(execute(board_, "version 2"), "ok");
  EXPECT_EQ(device::decode_telemetry(host_.read(1)->data).error, board::FrameError::kVersion);
  run(20, 0.0);
  EXPECT_THAT(board_.status(), testing::HasSubstr(R"("set_point_age_ms": null)"));
  EXPECT_EQ(execute(board_, "version 300"), "error: version 0 to 255");
  EXPECT_EQ(execute(board_, "dance"), "unknown");
}

TEST_F(Board, GarbageEndsTheConnectionOnly) {
  host_.send(Bytes(kTransferHead, 0xFF));
  EXPECT_FALSE(host_.session().open());
  board_.step();
}

const model::Quaternion kTilted = model::axis_angle({0.6, 0.8, 0.0}, 40.0);
constexpr const char* kTurn = "turn 0.93969262 0.20521209 0.27361612 0";

void expect_tilted(const model::Quaternion& q) {
  EXPECT_NEAR(std::abs(q.w * kTilted.w + q.x * kTilted.x + q.y * kTilted.y + q.z * kTilted.z), 1.0,
              1e-6);
}

TEST(Mti, UsesXbusAndHasTheSetOrientation) {
  MtiGadget mti("1");
  EXPECT_EQ(execute(mti, kTurn), "ok");
  FakeHost host(mti);
  device::MtiSession session;
  std::optional<device::MtSample> sample;
  for (int ms = 0; ms < 200; ++ms) {
    const auto request = session.due(ms * 1e-3);
    if (!request.empty()) host.write(2, request);
    if (const auto read = host.read(1)) session.receive(read->data, ms * 1e-3);
    while (const auto next = session.next()) sample = next;
  }
  ASSERT_TRUE(sample && sample->quaternion);
  expect_tilted(*sample->quaternion);
  EXPECT_EQ(sample->status, 3U);
}

TEST(HidSensor, IsSilentUntilSwitchedOnAndHasTheSetOrientation) {
  HidSensorGadget sensor("1");
  EXPECT_EQ(execute(sensor, kTurn), "ok");
  FakeHost host(sensor);
  const Bytes descriptor = host.control_in(0x81, 6, 0x2200, 0, 512).data;
  const auto parsed = device::parse_hid_descriptor(descriptor);
  ASSERT_TRUE(parsed);
  const auto codec = device::HidOrientation::find(*parsed);
  ASSERT_TRUE(codec);
  EXPECT_FALSE(host.read(1, 300));

  Bytes feature = host.control_in(0xA1, 1, 0x0301, 0, 64).data;
  ASSERT_EQ(feature.size(), codec->feature_bytes(1));
  codec->switch_on(feature, 0.01);
  EXPECT_EQ(host.control_out(0x21, 9, 0x0301, 0, feature).status, 0);
  host.run(20);
  const auto report = host.next(true);
  ASSERT_TRUE(report);
  const auto sample = codec->decode(report->data);
  ASSERT_TRUE(sample);
  expect_tilted(sample->quaternion);
}

TEST(DualSense, MeasuresGravityThroughItsOwnCalibration) {
  PadGadget pad("1");
  EXPECT_EQ(execute(pad, kTurn), "ok");
  FakeHost host(pad);
  const auto calibration = decode_calibration(device::SonyPad::kDualSense, device::SonyBus::kUsb,
                                              host.control_in(0xA1, 1, 0x0305, 0, 41).data);
  ASSERT_TRUE(calibration);
  const auto sample =
      decode_sony(device::SonyPad::kDualSense, host.read(1, 8).value().data, *calibration);
  ASSERT_TRUE(sample);
  const model::Vec3 up = rotate(conjugate(kTilted), {0, 0, 1});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(sample->accel_g[i], up[i], 2e-4);
    EXPECT_NEAR(sample->rate_deg_s[i], 0.0, 1e-6);
  }
}

TEST(Temper, RespondsOnItsSecondInterface) {
  TemperGadget stick("1");
  EXPECT_EQ(execute(stick, "temperature -3.5"), "ok");
  FakeHost host(stick);
  const auto request = [&](const device::TemperReport& report) {
    host.control_out(0x21, 9, 0x0200, 1, Bytes(report.begin(), report.end()));
    return host.read(2).value().data;
  };
  Bytes firmware = request(device::kTemperAskFirmware);
  const Bytes rest = host.read(2).value().data;
  firmware.insert(firmware.end(), rest.begin(), rest.end());
  const auto model = device::temper_model(device::temper_firmware(firmware));
  ASSERT_TRUE(model);
  const auto reading = decode_temper(*model, request(device::kTemperAskTemperature));
  ASSERT_TRUE(reading);
  EXPECT_DOUBLE_EQ(reading->internal_c.value(), -3.5);
  EXPECT_FALSE(reading->external_c);
}

}  // namespace
}  // namespace hedgehog::emulator
