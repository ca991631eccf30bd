// SPDX-License-Identifier: MIT
#include "emulator/imu_gadgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>

#include "emulator/words.h"

namespace hedgehog::emulator {
namespace {

using device::MtDataId;
using device::XbusId;

constexpr std::uint8_t kReports = 1;  // the endpoint

void put_float(Bytes& to, double value) {
  put_u32(to, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

void put_data_head(Bytes& to, MtDataId id, std::size_t length) {
  put_u16(to, static_cast<std::uint16_t>(id));
  to.push_back(static_cast<Byte>(length));
}

void put_little(Bytes& to, std::size_t at, std::uint32_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) to[at + i] = static_cast<Byte>(value >> 8 * i);
}

std::uint32_t rounded(double value) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value)));
}

// ---- HID sensor ------------------------------------------------------------------------------

constexpr double kPerOne = 10'000.0;

Bytes orientation_descriptor() {
  return {0x05, 0x20, 0x09, 0x8A, 0xA1, 0x00, 0x85,
          0x01,  // Sensor, Device Orientation, report 1
                 // Feature: reporting state (none, all events), power state (undefined, full):
                 // selectors
          0x0A, 0x16, 0x03, 0x15, 0x01, 0x25, 0x02, 0x75, 0x08, 0x95, 0x01, 0xA1, 0x02,  //
          0x0A, 0x40, 0x08, 0x0A, 0x41, 0x08, 0xB1, 0x00, 0xC0,                          //
          0x0A, 0x19, 0x03, 0xA1, 0x02, 0x0A, 0x50, 0x08, 0x0A, 0x51, 0x08, 0xB1, 0x00, 0xC0,
          // Feature: report interval, ms
          0x0A, 0x0E, 0x03, 0x15, 0x00, 0x27, 0xFF, 0xFF, 0xFF, 0x7F, 0x75, 0x20, 0x55, 0x00, 0xB1,
          0x02,
          // Input: quaternion, four of 16 bits, exponent -4
          0x0A, 0x83, 0x04, 0x16, 0xF0, 0xD8, 0x26, 0x10, 0x27, 0x55, 0x0C, 0x75, 0x10, 0x95, 0x04,
          0x81, 0x02, 0xC0};
}

// From REP-103 (x to the front) to the convention of hand-held devices (x to the right edge).
const model::Quaternion kToHandheld{std::sqrt(0.5), 0, 0, -std::sqrt(0.5)};

GadgetShape hid_shape(std::uint16_t vendor, std::uint16_t product, const std::string& maker,
                      const std::string& name, const std::string& serial,
                      std::vector<EndpointShape> endpoints, Bytes descriptor) {
  constexpr std::uint8_t kHid = 3;
  return {vendor, product, maker,
          name,   serial,  {{kHid, 0, 0, std::move(endpoints), std::move(descriptor)}}};
}

// ---- DualSense -------------------------------------------------------------------------------

constexpr std::size_t kPadReport = 64;
constexpr std::uint32_t kClockPerMs = 3000;
constexpr double kPerG = 8192.0;
constexpr std::array<int, 3> kFactoryBias{12, -7, 5};

/// Game pad with one input report, one output report and the feature reports used by its driver.
Bytes pad_descriptor() {
  return {0x05, 0x01, 0x09, 0x05, 0xA1, 0x01,                          //
          0x06, 0x00, 0xFF, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,  //
          0x85, 0x01, 0x09, 0x20, 0x95, 0x3F, 0x81, 0x02,              //
          0x85, 0x02, 0x09, 0x21, 0x95, 0x2F, 0x91, 0x02,              //
          0x85, 0x05, 0x09, 0x22, 0x95, 0x28, 0xB1, 0x02,              //
          0x85, 0x09, 0x09, 0x23, 0x95, 0x13, 0xB1, 0x02,              //
          0x85, 0x20, 0x09, 0x24, 0x95, 0x3F, 0xB1, 0x02, 0xC0};
}

Bytes pad_calibration() {
  Bytes report(41);
  report[0] = 0x05;
  const auto put = [&report](std::size_t at, int value) {
    put_little(report, at, static_cast<std::uint32_t>(value), 2);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    put(1 + 2 * i, kFactoryBias[i]);
    put(7 + 4 * i, 8640 + kFactoryBias[i]);
    put(9 + 4 * i, -8640 + kFactoryBias[i]);
    put(23 + 4 * i, static_cast<int>(kPerG));
    put(25 + 4 * i, -static_cast<int>(kPerG));
  }
  put(19, 540);
  put(21, 540);
  return report;
}

}  // namespace

std::optional<std::string> ImuGadget::command(std::span<const std::string> words) {
  if (words[0] != "turn" || words.size() != 5) return std::nullopt;
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto value = number<double>(words[i + 1]);
    if (!value || !(std::abs(*value) <= 1e6)) return "error: turn W X Y Z";
    q[i] = *value;
  }
  const double length = norm(model::Quaternion{q[0], q[1], q[2], q[3]});
  if (length < 1e-6) return "error: turn W X Y Z, not all of them 0";
  turned_ = {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
  return "ok";
}

std::string ImuGadget::status() const {
  return fmt::format(R"({{"quaternion": [{:.6f}, {:.6f}, {:.6f}, {:.6f}], "running": {}, )"
                     R"("reports": {}, "lost": {}}})",
                     turned_.w, turned_.x, turned_.y, turned_.z, running(), reports_, lost());
}

void ImuGadget::step() {
  if (!running() || --until_report_ > 0) return;
  until_report_ = std::max(1, period_ms());
  report();
  ++reports_;
}

MtiGadget::MtiGadget(const std::string& serial)
    : ImuGadget({0x2639,
                 0x0003,
                 "Xsens",
                 "MTi-30",
                 serial,
                 {{0xFF, 0, 0, {{0x02, true, 64}, {0x81, true, 64}}, {}}}}) {}

void MtiGadget::print(XbusId id, std::span<const Byte> payload) {
  // A message is sent as a byte stream in packets of 64 bytes.
  const Bytes bytes = device::encode_xbus(id, payload);
  for (std::size_t at = 0; at < bytes.size(); at += 64) {
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto size = static_cast<std::ptrdiff_t>(std::min<std::size_t>(64, bytes.size() - at));
    give(kReports, Bytes(from, from + size));
  }
}

void MtiGadget::handle_out(std::uint8_t /*endpoint*/, std::span<const Byte> data) {
  parser_.feed(data);
  while (const auto message = parser_.next()) answer(*message);
}

void MtiGadget::answer(const device::XbusMessage& message) {
  constexpr std::uint16_t kFastestHz = 400;
  constexpr Byte kInvalidParameter = 0x04;
  if (message.id == XbusId::kGotoConfig) {
    measuring_ = false;
    print(XbusId::kGotoConfigAck);
  } else if (message.id == XbusId::kGotoMeasurement) {
    measuring_ = true;
    print(XbusId::kGotoMeasurementAck);
  } else if (message.id == XbusId::kSetOutputConfiguration) {
    const auto asked = device::decode_outputs(message.payload);
    std::uint16_t rate = 100;
    for (const device::MtOutput& output : asked.value_or(std::vector<device::MtOutput>{}))
      if (output.rate_hz != 0xFFFF) rate = output.rate_hz;
    if (!asked || rate == 0 || rate > kFastestHz) {
      print(XbusId::kError, Bytes{kInvalidParameter});
      return;
    }
    outputs_ = *asked;
    period_ms_ = 1000 / rate;
    print(XbusId::kOutputConfiguration, message.payload);
  }
}

void MtiGadget::report() {
  constexpr std::uint32_t kValid = 3;  // self-test passed, orientation valid
  Bytes payload;
  time_ += 10 * static_cast<std::uint32_t>(period_ms_);
  for (const device::MtOutput& output : outputs_) {
    const auto id = static_cast<MtDataId>(output.id);
    if (id == MtDataId::kPacketCounter) {
      put_data_head(payload, id, 2);
      put_u16(payload, counter_++);
    } else if (id == MtDataId::kSampleTimeFine) {
      put_data_head(payload, id, 4);
      put_u32(payload, time_);
    } else if (id == MtDataId::kQuaternion) {
      put_data_head(payload, id, 16);
      const model::Quaternion& q = turned();
      for (const double value : {q.w, q.x, q.y, q.z}) put_float(payload, value);
    } else if (id == MtDataId::kRateOfTurn) {
      put_data_head(payload, id, 12);
      for (int i = 0; i < 3; ++i) put_float(payload, 0.0);
    } else if (id == MtDataId::kStatusWord) {
      put_data_head(payload, id, 4);
      put_u32(payload, kValid);
    }
  }
  print(XbusId::kMtData2, payload);
}

HidSensorGadget::HidSensorGadget(const std::string& serial)
    : ImuGadget(hid_shape(0x1209, 0x0002, "Hedgehog", "Orientation sensor", serial,
                          {{0x81, false, 64}}, orientation_descriptor())) {}

int HidSensorGadget::period_ms() const {
  return static_cast<int>(std::clamp<std::uint32_t>(device::little_u32(&feature_[3]), 1, 60'000));
}

void HidSensorGadget::report() {
  const model::Quaternion q = turned() * kToHandheld;
  Bytes bytes(9);
  bytes[0] = 1;
  std::size_t at = 1;
  for (const double value : {q.x, q.y, q.z, q.w}) {
    put_little(bytes, at, rounded(kPerOne * value), 2);
    at += 2;
  }
  give(kReports, std::move(bytes));
}

std::optional<Bytes> HidSensorGadget::handle_control(const SetupPacket& setup,
                                                     std::span<const Byte> data) {
  if (setup.type == kHidToHost && setup.request == kHidGetReport)
    return Bytes(feature_.begin(), feature_.end());
  if (setup.type != kHidToDevice) return std::nullopt;
  if (setup.request == kHidSetReport && data.size() == feature_.size() && data[0] == 1)
    std::copy(data.begin(), data.end(), feature_.begin());
  return Bytes{};
}

PadGadget::PadGadget(const std::string& serial)
    : ImuGadget(hid_shape(0x054C, 0x0CE6, "Sony Interactive Entertainment", "Wireless Controller",
                          serial, {{0x81, false, 64}, {0x02, false, 64}}, pad_descriptor())) {}

void PadGadget::report() {
  Bytes bytes(kPadReport);
  bytes[0] = 0x01;
  clock_ += kClockPerMs * static_cast<std::uint32_t>(period_ms());
  const model::Vec3 felt = rotate(conjugate(turned()), {0, 0, 1});
  const std::array<double, 3> accel{-felt.y, felt.z, -felt.x};
  // At rest the gyroscope reads 0; the factory bias is only in the calibration report.
  for (std::size_t i = 0; i < 3; ++i) put_little(bytes, 22 + 2 * i, rounded(kPerG * accel[i]), 2);
  put_little(bytes, 28, clock_, 4);
  give(kReports, std::move(bytes));
}

std::optional<Bytes> PadGadget::handle_control(const SetupPacket& setup,
                                               std::span<const Byte> /*data*/) {
  constexpr Byte kCalibration = 0x05;
  constexpr Byte kPairing = 0x09;
  constexpr Byte kFirmware = 0x20;
  if (setup.type == kHidToDevice) return Bytes{};
  if (setup.type != kHidToHost || setup.request != kHidGetReport) return std::nullopt;
  const auto id = static_cast<Byte>(setup.value);
  if (id == kCalibration) return pad_calibration();
  Bytes report(id == kPairing ? 20 : 64);
  report[0] = id;
  if (id == kPairing) report[1] = 0x42;
  if (id != kPairing && id != kFirmware) return std::nullopt;
  return report;
}

}  // namespace hedgehog::emulator
