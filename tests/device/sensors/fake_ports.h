// SPDX-License-Identifier: MIT
// Devices in memory: ports filled by a test, an opener that provides them, and the recorded
// samples.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "daemon/device/sensors/port.h"
#include "daemon/device/sensors/sensor.h"

namespace hedgehog::device {

/// The device: outlives its ports, as a real one does.
struct FakeHid {
  bool plugged = true;
  std::string failure;
  std::vector<Byte> descriptor;
  bool bluetooth = false;
  std::deque<std::vector<Byte>> reports;
  std::map<Byte, std::vector<Byte>> features;
  std::vector<std::vector<Byte>> written;
  /// Returns the response to what is written, when set.
  std::function<std::vector<std::vector<Byte>>(const std::vector<Byte>&)> respond;
  int open_ports = 0;
  int opened = 0;

  OpenHid opener();
};

class FakeHidPort : public HidPort {
 public:
  explicit FakeHidPort(FakeHid& device) : device_(device) {
    ++device_.open_ports;
    ++device_.opened;
  }
  ~FakeHidPort() override { --device_.open_ports; }

  std::optional<std::size_t> read(std::span<Byte> report, std::chrono::milliseconds) override {
    if (!device_.plugged) return std::nullopt;
    if (device_.reports.empty()) return 0;
    const std::vector<Byte> next = device_.reports.front();
    device_.reports.pop_front();
    const std::size_t length = std::min(next.size(), report.size());
    std::copy_n(next.begin(), length, report.begin());
    return length;
  }
  bool write(std::span<const Byte> report) override {
    device_.written.emplace_back(report.begin(), report.end());
    if (device_.respond)
      for (auto& reply : device_.respond(device_.written.back())) device_.reports.push_back(reply);
    return device_.plugged;
  }
  std::size_t get_feature(std::span<Byte> report) override {
    const auto found = device_.features.find(report[0]);
    if (found == device_.features.end()) return 0;
    const std::size_t length = std::min(found->second.size(), report.size());
    std::copy_n(found->second.begin(), length, report.begin());
    return length;
  }
  bool send_feature(std::span<const Byte> report) override {
    device_.features[report[0]].assign(report.begin(), report.end());
    return true;
  }

 private:
  FakeHid& device_;
};

inline OpenHid FakeHid::opener() {
  return [this]() -> OpenedHid {
    if (!failure.empty()) return {nullptr, failure, {}, {}, false};
    if (!plugged) return {nullptr, "no fake is connected", {}, {}, false};
    return {std::make_unique<FakeHidPort>(*this), {}, "Fake (1234:5678)", descriptor, bluetooth};
  };
}

/// Passes what is written to `device`, and reads its response.
class FakeBytePort : public BytePort {
 public:
  using Device = std::function<std::vector<Byte>(const std::vector<Byte>&)>;
  explicit FakeBytePort(Device device) : device_(std::move(device)) {}

  std::optional<std::size_t> read(std::span<Byte> bytes, std::chrono::milliseconds) override {
    const auto more = device_({});
    waiting_.insert(waiting_.end(), more.begin(), more.end());
    const std::size_t length = std::min(waiting_.size(), bytes.size());
    std::copy_n(waiting_.begin(), length, bytes.begin());
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(length));
    return length;
  }
  bool write(std::span<const Byte> bytes) override {
    const auto more = device_({bytes.begin(), bytes.end()});
    waiting_.insert(waiting_.end(), more.begin(), more.end());
    return true;
  }

 private:
  Device device_;
  std::vector<Byte> waiting_;
};

/// Virtual time, and what was published in it.
struct Desk {
  model::Tick now = 0;
  std::vector<OrientationSample> samples;
  std::vector<ThermometerSample> readings;

  OrientationSink orientation(Mounting mounting = {}) {
    return {[this] { return now; }, mounting,
            [this](const OrientationSample& s) { samples.push_back(s); }};
  }
  ThermometerSink thermometer() {
    return {[this] { return now; }, [this](const ThermometerSample& s) { readings.push_back(s); }};
  }
};

}  // namespace hedgehog::device
