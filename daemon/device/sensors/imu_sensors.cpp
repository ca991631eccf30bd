// SPDX-License-Identifier: MIT
#include "daemon/device/sensors/imu_sensors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "daemon/device/sensors/drivers.h"
#include "model/units.h"

namespace hedgehog::device {
namespace {

constexpr std::size_t kLongestReport = 1024;
// A pad may have been turned during a pause. The clock of a DualShock 4 wraps in 350 ms, so a pause
// of that length has to be detected by the host's clock; by then the kernel's queue of 64 reports
// has overflowed.
constexpr double kLongestStepS = 0.1;
constexpr model::Tick kLongestPause = 300;

constexpr std::array<UsbIds, 2> kDualSenseIds{{{0x054C, 0x0CE6}, {0x054C, 0x0DF2}}};
constexpr std::array<UsbIds, 3> kDualShock4Ids{
    {{0x054C, 0x05C4}, {0x054C, 0x09CC}, {0x054C, 0x0BA0}}};
constexpr std::uint16_t kXsens = 0x2639;
constexpr std::array<UsbIds, 7> kMtiIds{{{kXsens, 0x0001},
                                         {kXsens, 0x0002},
                                         {kXsens, 0x0003},
                                         {kXsens, 0x0011},
                                         {kXsens, 0x0012},
                                         {kXsens, 0x0013},
                                         {kXsens, 0x0017}}};

/// Bit of an MTi's status word: its filter is valid.
constexpr std::uint32_t kOrientationValid = 2;

/// Mean rate from `a` to `b`, in the axes of the rotated body.
model::Vec3 rate_between(const model::Quaternion& a, const model::Quaternion& b, double dt_s) {
  model::Quaternion d = conjugate(a) * b;
  if (d.w < 0.0) d = {-d.w, -d.x, -d.y, -d.z};
  const model::Vec3 v{d.x, d.y, d.z};
  const double sine = norm(v);
  const double angle_deg = 2.0 * std::atan2(sine, d.w) * model::kDegreesPerRadian;
  return sine > 1e-9 ? (angle_deg / (sine * dt_s)) * v : model::Vec3{};
}

bool contains(const std::vector<Byte>& descriptor, std::array<Byte, 2> item) {
  return std::search(descriptor.begin(), descriptor.end(), item.begin(), item.end()) !=
         descriptor.end();
}

/// Usage page 0x20, then Device or Relative Orientation; `open` parses the rest.
bool is_hid_sensor(const HidDevice& device) {
  const bool oriented =
      contains(device.descriptor, {0x09, 0x8A}) || contains(device.descriptor, {0x09, 0x8E});
  return oriented && contains(device.descriptor, {0x05, 0x20});
}

template <SonyPad pad>
std::unique_ptr<Sensor> make_sony(OpenHid open, const SensorSinks& sinks) {
  return std::make_unique<SonyImu>(pad, std::move(open), sinks.orientation);
}

}  // namespace

std::string HidSensorImu::open() {
  OpenedHid opened = open_();
  if (!opened.port) return opened.failure;
  const auto descriptor = parse_hid_descriptor(opened.descriptor);
  codec_ = descriptor ? HidOrientation::find(*descriptor) : std::nullopt;
  if (!codec_) return opened.name + ": its report descriptor has no orientation";
  for (const std::uint8_t id : codec_->feature_ids()) {
    std::vector<Byte> report(codec_->feature_bytes(id));
    report[0] = id;
    if (opened.port->get_feature(report) == 0) std::fill(report.begin() + 1, report.end(), Byte{0});
    codec_->switch_on(report, kIntervalS);
    // Some sensors run without it; others stay silent, which results in a stale orientation.
    (void)opened.port->send_feature(report);
  }
  name_ = opened.name;
  port_ = std::move(opened.port);
  last_.reset();
  return {};
}

bool HidSensorImu::poll(std::chrono::milliseconds wait) {
  std::array<Byte, kLongestReport> report;
  const auto length = port_->read(report, wait);
  if (!length) return false;
  if (const auto sample = codec_->decode(std::span(report).first(*length))) publish(*sample);
  return true;
}

void HidSensorImu::publish(const HidOrientationSample& sample) {
  const model::Tick now = sink_.tick();
  const model::Tick since = now - last_tick_;
  model::Vec3 rate;
  if (sample.rate_deg_s) {
    rate = *sample.rate_deg_s;
  } else if (last_ && since > 0 && since < model::kTicksPerSecond) {
    rate =
        rate_between(*last_, sample.quaternion, static_cast<double>(since) * model::kTickSeconds);
  }
  last_ = sample.quaternion;
  last_tick_ = now;
  sink_.publish(sample.quaternion, rate);
}

std::string SonyImu::open() {
  OpenedHid opened = open_();
  if (!opened.port) return opened.failure;
  const SonyBus bus = opened.bluetooth ? SonyBus::kBluetooth : SonyBus::kUsb;
  const SonyCalibrationReport expected = calibration_report(pad_, bus);
  std::vector<Byte> report(expected.bytes);
  report[0] = expected.id;
  // Reading it also makes a pad on Bluetooth send its full reports.
  const std::size_t length = opened.port->get_feature(report);
  report.resize(std::min(length, report.size()));
  calibration_ = decode_calibration(pad_, bus, report).value_or(SonyCalibration::nominal());
  name_ = opened.name;
  port_ = std::move(opened.port);
  // The pad may have been turned while closed, but the gyroscope's bias is still valid.
  clock_us_.reset();
  fusion_.restart();
  return {};
}

bool SonyImu::poll(std::chrono::milliseconds wait) {
  std::array<Byte, kLongestReport> report;
  const auto length = port_->read(report, wait);
  if (!length) return false;
  const auto sample = decode_sony(pad_, std::span(report).first(*length), calibration_);
  if (!sample) return true;
  const double dt_s = clock_us_ ? sony_elapsed_s(pad_, *clock_us_, sample->clock_us) : 0.0;
  const model::Tick now = sink_.tick();
  if (dt_s > kLongestStepS || now - last_tick_ > kLongestPause) fusion_.restart();
  clock_us_ = sample->clock_us;
  last_tick_ = now;
  if (dt_s <= 0.0 || dt_s > kLongestStepS) return true;
  fusion_.step({sample->rate_deg_s, sample->accel_g, dt_s});
  if (fusion_.started()) sink_.publish(fusion_.sensor_to_world(), fusion_.rate_deg_s());
  return true;
}

std::string MtiImu::open() {
  OpenedBytes opened = open_();
  if (!opened.port) return opened.failure;
  name_ = opened.name;
  port_ = std::move(opened.port);
  session_ = MtiSession();
  return {};
}

bool MtiImu::poll(std::chrono::milliseconds wait) {
  const std::vector<Byte> request = session_.due(now_s());
  if (!request.empty() && !port_->write(request)) return false;
  std::array<Byte, 2048> bytes;
  const auto length = port_->read(bytes, wait);
  if (!length) return false;
  session_.receive(std::span(bytes).first(*length), now_s());
  while (const auto sample = session_.next()) {
    const bool valid = !sample->status || (*sample->status & kOrientationValid) != 0;
    if (!valid || !sample->quaternion) continue;
    sink_.publish(*sample->quaternion,
                  model::kDegreesPerRadian * sample->rate_rad_s.value_or(model::Vec3{}));
  }
  return true;
}

constinit const SensorDriver kHidSensorDriver{
    .type = "hid_sensor",
    .words = "HID orientation sensor",
    .matches_hid = is_hid_sensor,
    .make_hid = [](OpenHid open, const SensorSinks& sinks) -> std::unique_ptr<Sensor> {
      return std::make_unique<HidSensorImu>(std::move(open), sinks.orientation);
    }};

constinit const SensorDriver kDualSenseDriver{
    .type = "dualsense",
    .words = "DualSense pad",
    .matches_hid = [](const HidDevice& device) { return has_ids(device, kDualSenseIds); },
    .make_hid = make_sony<SonyPad::kDualSense>};

constinit const SensorDriver kDualShock4Driver{
    .type = "dualshock4",
    .words = "DualShock 4 pad",
    .matches_hid = [](const HidDevice& device) { return has_ids(device, kDualShock4Ids); },
    .make_hid = make_sony<SonyPad::kDualShock4>};

constinit const SensorDriver kMtiDriver{
    .type = "mti",
    .words = "Xsens MTi",
    .matches_usb = [](const UsbDevice& device) { return has_ids(device, kMtiIds); },
    .make_usb = [](OpenBytes open, const SensorSinks& sinks) -> std::unique_ptr<Sensor> {
      return std::make_unique<MtiImu>(std::move(open), sinks.orientation);
    }};

constinit const SensorDriver kClosedXsensDriver{
    .type = {},
    .words = "Xsens radio station or converter",
    .matches_usb = [](const UsbDevice& device) { return device.vendor == kXsens; },
    .unusable = "only the manufacturer's closed software supports it"};

}  // namespace hedgehog::device
