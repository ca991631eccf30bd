// SPDX-License-Identifier: MIT
// The firmware's image as a USB device of the kernel: the emulated board of
// tests/firmware/emulated/usbip.mjs, on the host in lock-step with the guest. Times are the
// board's.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "tests/e2e/programs.h"
#include "tests/vm/bench.h"

namespace hedgehog::vm {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::Ge;
using testing::Gt;
using testing::HasSubstr;
using testing::Le;
using testing::Lt;

// tests/firmware/emulated/safety-table.md.
constexpr double kMinDeadManUs = 99e3;
constexpr double kMaxDeadManUs = 101e3;
/// Set-points that were sent a few milliseconds before the unplugging, in the guest's time.
constexpr double kMaxUnpluggedUs = 20e3;
/// 5 L/R of a winding, and a millisecond.
constexpr double kDecayUs = 19e3;
constexpr double kNoCurrentA = 0.001;
constexpr int kZeroPollMs = 10;
constexpr int kZeroTimeoutMs = 300;

/// The flash id of tests/firmware/emulated/chip.mjs.
constexpr const char* kSerial = "E4628C11275A3F2B";
/// Device and configuration, as tests/firmware/emulated/usb.test.mjs reads them.
constexpr const char* kDescriptors =
    "120110020000004009120100020101020301"
    "09022000010100804b0904000002ff4801000705010240000007058102400000";

class FirmwareBoard : public Bench {
 protected:
  FirmwareBoard() : Bench({"firmware-board,name=board,unplugged"}) {}
  void TearDown() override {
    daemon_.reset();
    report("end of the test");
    // A signal would end it within an exchange with the host.
    emulator_->quit();
  }

  /// Prints the board's events since the last report, and a line of the test's.
  void report(const std::string& text) {
    const Json board = emulator_->status("board");
    std::istringstream lines(home_.read("trace"));
    std::size_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      if (++number <= reported_) continue;
      const Json event = Json::parse(line);
      const auto peak = event["peak_ma"].get<std::array<double, 3>>();
      std::printf("  %12.3f ms  board: %-7s %s  peak %6.0f %6.0f %6.0f mA\n",
                  event["us"].get<double>() / 1e3, event["event"].get<std::string>().c_str(),
                  age_text(event["since_set_point_us"]).c_str(), peak[0], peak[1], peak[2]);
    }
    reported_ = std::max(reported_, number);
    std::printf("  %12.3f ms  test:  %s\n", board["board_us"].get<double>() / 1e3, text.c_str());
  }

  void begin() {
    configure();
    daemon_.emplace(home_);
    plug();
    daemon_->arm();
    report("armed");
  }
  void plug() {
    emulator_->ok("plug board");
    ASSERT_TRUE(daemon_->is("disarmed")) << daemon_->status();
    report("plugged in, found by hedgehogd");
  }
  /// Drives 15 A upwards, for longer than any test.
  void drive() {
    const Json admitted = daemon_->call(
        "effect.pulse", {{"direction", "up"}, {"current_a", 15}, {"duration_ms", 10'000}});
    ASSERT_TRUE(admitted.value("accepted", false)) << admitted;
    ASSERT_TRUE(eventually([&] { return emulator_->current_a() > 14.5; }));
    driven_us_ = emulator_->status("board")["board_us"];
    report("15 A flow");
  }
  /// Plays 5 A; the plant's true current follows.
  void expect_plays() {
    daemon_->arm();
    EXPECT_THAT(daemon_->pulse(*emulator_, 5.0, 200), AllOf(Ge(4.8), Le(5.3)));
    report("a pulse of 5 A");
  }
  void expect_no_current() {
    EXPECT_LT(emulator_->current_a(), kNoCurrentA);
    pause_ms(20);
    EXPECT_LT(emulator_->status("board")["peak_a"], kNoCurrentA);
    EXPECT_EQ(emulator_->status("board")["awake"], false);
  }
  /// The board's latest event of that name since 15 A flowed.
  Json since_driven(const std::string& name) const {
    const Json event = emulator_->last(name);
    return event.is_object() && event["us"].get<double>() > driven_us_ ? event : Json();
  }
  /// Expects that the current of a board that has driven until now ends after its `event`, which
  /// occurs `min_us` to `max_us` after the last set-point by the board's own clock.
  void expect_ends(const std::string& hazard, const std::string& event, double min_us,
                   double max_us) {
    const auto ended = [&] { return since_driven("zero").is_object(); };
    for (int waited_ms = 0; !ended() && waited_ms < kZeroTimeoutMs; waited_ms += kZeroPollMs)
      pause_ms(kZeroPollMs);
    report(hazard);
    ASSERT_TRUE(ended()) << emulator_->status("board");
    const Json begun = since_driven(event);
    const Json zero = since_driven("zero");
    ASSERT_TRUE(begun.is_object()) << home_.read("trace");
    const double age_us = begun["since_set_point_us"];
    ASSERT_THAT(age_us, AllOf(Ge(min_us), Le(max_us)));
    EXPECT_LT(zero["us"].get<double>() - begun["us"].get<double>(), kDecayUs);
    expect_no_current();
    figure("firmware: bridges asleep after " + hazard, age_us / 1e3, "ms of the board");
  }
  void expect_no_bus_errors() const { EXPECT_EQ(emulator_->status("board")["bus_errors"], 0); }

  std::optional<Daemon> daemon_;

 private:
  /// Of the last set-point; one that arrived within the millisecond after the event has none.
  static std::string age_text(const Json& age_us) {
    const double age_ms = age_us.is_null() ? -1.0 : age_us.get<double>() / 1e3;
    if (age_ms < 0.0) return std::string(28, ' ');
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%8.3f ms after a set-point", age_ms);
    return text.data();
  }

  std::size_t reported_ = 0;
  /// The board's time when 15 A flowed; earlier events are not those of a hazard.
  double driven_us_ = 0.0;
};

/// What the kernel has read of the device with the board's serial number.
std::string kernel_descriptors() {
  for (const auto& entry : std::filesystem::directory_iterator("/sys/bus/usb/devices")) {
    std::ifstream serial(entry.path() / "serial");
    std::string text;
    if (!std::getline(serial, text) || text != kSerial) continue;
    std::ifstream file(entry.path() / "descriptors", std::ios::binary);
    std::string hex;
    for (std::istreambuf_iterator<char> byte(file), end; byte != end; ++byte) {
      char two[3];
      std::snprintf(two, sizeof two, "%02x", static_cast<unsigned char>(*byte));
      hex += two;
    }
    return hex;
  }
  return {};
}

TEST_F(FirmwareBoard, IsEnumeratedByTheKernelAndListedByItsSerialNumber) {
  configure();
  daemon_.emplace(home_);
  const double plugged_ms = now_ms();
  plug();
  figure("firmware: plug to ready, the first time", now_ms() - plugged_ms, "ms");
  EXPECT_EQ(kernel_descriptors(), kDescriptors);
  const Json board = daemon_->call("device.describe")["board"];
  EXPECT_EQ(board["backend"], "usb");
  EXPECT_EQ(board["serial"], kSerial);

  std::string command = "env";
  for (const std::string& variable : home_.environment()) command += " '" + variable + "'";
  const std::string devices = shell(command + " " + e2e::hedgehogctl() + " devices");
  EXPECT_THAT(devices, HasSubstr(kSerial));
  EXPECT_THAT(devices, HasSubstr("1209:0001"));
  EXPECT_THAT(devices, ContainsRegex("firmware[ \n]+1\\.02,[ \n]+protocol[ \n]+1\\.2"));
  std::printf("  hedgehogctl devices:\n%s", devices.c_str());
  expect_no_current();
  expect_no_bus_errors();
}

TEST_F(FirmwareBoard, ExchangesAFrameAMillisecondAndPlaysAPulseAndACircle) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const Json before = daemon_->status();
  pause_ms(500);
  const Json after = daemon_->status();
  const auto more = [&](const char* what) {
    return after["link"][what].get<double>() - before["link"][what].get<double>();
  };
  EXPECT_GT(more("frames_out"), 450);
  EXPECT_LE(more("lost"), 5);
  EXPECT_EQ(more("errors"), 0);
  figure("firmware: frames to the board in half a second", more("frames_out"), "");
  figure("firmware: of as many from it, lost", more("lost"), "");
  // In more time the guest would depend on how busy the host is.
  const Json board = emulator_->status("board");
  EXPECT_LT(board["exchange_us"], 500);
  figure("firmware: a millisecond of the board, in the guest's time", board["exchange_us"], "us");
  figure("firmware: the longest one", board["max_exchange_us"], "us");

  daemon_->call("events.subscribe");
  const Json pulse = daemon_->call(
      "effect.pulse", {{"direction", "left"}, {"current_a", 10}, {"duration_ms", 200}});
  ASSERT_TRUE(pulse.value("accepted", false)) << pulse;
  EXPECT_EQ(daemon_->client().notification("event", "effect_ended")["reason"], "completed");
  ASSERT_TRUE(eventually([&] { return emulator_->last("asleep").is_object(); }));
  report("a pulse of 10 A to the left");
  const auto [x, y, z] = emulator_->last("asleep")["peak_ma"].get<std::array<double, 3>>();
  EXPECT_THAT(y, AllOf(Gt(9700), Lt(10'400)));
  EXPECT_LT(std::hypot(x, z), 300);

  const Json circle =
      daemon_->call("effect.circle", {{"axis", "up"}, {"current_a", 6}, {"duration_ms", 1500}});
  ASSERT_TRUE(circle.value("accepted", false)) << circle;
  EXPECT_EQ(daemon_->client().notification("event", "effect_ended")["reason"], "completed");
  EXPECT_EQ(daemon_->stop(SIGTERM), 0);
  report("a circle of 6 A; hedgehogd stopped");
  const auto peak_ma = emulator_->last("asleep")["peak_ma"].get<std::array<double, 3>>();
  EXPECT_GT(std::abs(peak_ma[0]), 5500);
  EXPECT_GT(std::abs(peak_ma[1]), 5500);
  EXPECT_LT(std::abs(peak_ma[2]), 500);
  expect_no_current();
  expect_no_bus_errors();
}

TEST_F(FirmwareBoard, HasNoCurrentAfterTheDeadManWhenTheDaemonIsKilledAndIsArmedAgain) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(drive());
  EXPECT_EQ(daemon_->stop(SIGKILL), -1);
  ASSERT_NO_FATAL_FAILURE(
      expect_ends("SIGKILL of hedgehogd at 15 A", "asleep", kMinDeadManUs, kMaxDeadManUs));
  daemon_.emplace(home_);
  ASSERT_TRUE(daemon_->is("disarmed")) << daemon_->status();
  expect_no_current();
  expect_plays();
  expect_no_bus_errors();
}

// Without the cable the processor has no supply: a resistor lets the bridges sleep.
TEST_F(FirmwareBoard, HasNoCurrentAtOnceWhenUnpluggedAndIsFoundWhenPlugged) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(drive());
  emulator_->ok("unplug board");
  ASSERT_NO_FATAL_FAILURE(expect_ends("unplugging at 15 A", "unplugged", 0, kMaxUnpluggedUs));
  ASSERT_TRUE(daemon_->is("absent")) << daemon_->status();
  ASSERT_NO_FATAL_FAILURE(plug());
  expect_no_current();
  expect_plays();
  expect_no_bus_errors();
}

TEST_F(FirmwareBoard, GoesOnAfterItsEndpointsHaveStalled) {
  ASSERT_NO_FATAL_FAILURE(begin());
  for (const std::string endpoint : {"81", "1"}) {
    emulator_->ok("stall board " + endpoint);
    const auto frames = [&] { return emulator_->status("board")["frames_in"].get<int>(); };
    const int before = frames();
    ASSERT_TRUE(eventually([&] { return frames() > before + 50; })) << daemon_->log();
    ASSERT_TRUE(eventually([&] {
      return daemon_->state() != "absent" && daemon_->status()["temperature_c"]["age_ms"] < 50;
    }));
    report("endpoint " + endpoint + " has stalled and goes on");
    expect_plays();
  }
  EXPECT_EQ(daemon_->stop(SIGTERM), 0);
  ASSERT_TRUE(eventually([&] { return emulator_->current_a() < kNoCurrentA; }));
  expect_no_current();
  expect_no_bus_errors();
}

}  // namespace
}  // namespace hedgehog::vm
