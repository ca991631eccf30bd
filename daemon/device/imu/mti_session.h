// SPDX-License-Identifier: MIT
// The talk with an Xsens MTi: into its configuration, tell it what to send, into measurement, and
// again from the start when it falls silent or restarts. Pure: bytes and time go in, bytes and
// samples come out.
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
  /// Unanswered requests are repeated, and silence in measurement starts anew.
  static constexpr double kRepeatS = 0.2;
  static constexpr double kSilenceS = 1.0;

  /// What to send now; empty: nothing is due. Call it at least every 100 ms.
  std::vector<Byte> due(double now_s);
  /// What arrived.
  void receive(std::span<const Byte> bytes, double now_s);
  /// The samples of what arrived, oldest first.
  std::optional<MtSample> next();

  /// It measures, as we asked it to.
  bool measuring() const noexcept { return step_ == Step::kMeasuring; }

 private:
  enum class Step : std::uint8_t { kConfigure, kOutputs, kMeasure, kMeasuring };

  void take(const XbusMessage& message, double now_s);
  void go(Step step) noexcept;
  std::vector<Byte> request() const;

  Step step_ = Step::kConfigure;
  XbusParser parser_;
  std::deque<MtSample> samples_;
  /// When the request of this step was sent; none: not yet.
  std::optional<double> asked_s_;
  double received_s_ = 0.0;
  bool woken_ = false;
  /// Refused output rates so far.
  std::size_t refused_ = 0;
};

}  // namespace hedgehog::device
