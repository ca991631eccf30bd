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
  /// Unanswered requests are repeated; silence in measurement restarts the session.
  static constexpr double kRepeatS = 0.2;
  static constexpr double kSilenceS = 1.0;

  /// The bytes to send now; empty: none. Call it at least every 100 ms.
  std::vector<Byte> due(double now_s);
  /// Processes received bytes.
  void receive(std::span<const Byte> bytes, double now_s);
  /// Received samples, oldest first.
  std::optional<MtSample> next();

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
  /// Time of the request of this step; nullopt: not yet sent.
  std::optional<double> requested_s_;
  double received_s_ = 0.0;
  bool woken_ = false;
  /// Number of rejected output rates.
  std::size_t refused_ = 0;
};

}  // namespace hedgehog::device
