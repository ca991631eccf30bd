// SPDX-License-Identifier: MIT
// Session with an Xsens MTi: enter configuration, configure the outputs, enter measurement, and
// start again when it stops sending or restarts. Pure: bytes and time in, bytes and samples out.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "daemon/device/imu/mtdata2.h"
#include "daemon/device/imu/xbus.h"

namespace hedgehog::device {

/// The reader's thread.
class MtiSession {
 public:
  static constexpr double kRepeatS = 0.2;   // of unanswered requests
  static constexpr double kSilenceS = 1.0;  // in measurement: restarts the session

  std::vector<Byte> due(double now_s);  // to send now; call it at least every 100 ms
  void receive(std::span<const Byte> bytes, double now_s);
  std::optional<MtSample> next();  // received samples, oldest first

  /// In measurement, with the requested outputs.
  bool measuring() const noexcept { return step_ == Step::kMeasuring; }

 private:
  enum class Step : std::uint8_t { kConfigure, kOutputs, kMeasure, kMeasuring };

  void take(const XbusMessage& message, double now_s);
  void go(Step step) noexcept;
  std::vector<Byte> request() const;

  Step step_ = Step::kConfigure;
  XbusParser parser_;
  std::deque<MtSample> samples_;
  std::optional<double> requested_s_;  // of this step; nullopt: not yet sent
  double received_s_ = 0.0;
  bool woken_ = false;
  std::size_t refused_ = 0;  // number of rejected output rates
};

}  // namespace hedgehog::device
