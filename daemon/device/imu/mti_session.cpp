// SPDX-License-Identifier: MIT
#include "daemon/device/imu/mti_session.h"

#include <algorithm>
#include <array>

namespace hedgehog::device {
namespace {

// Not every model supports every rate; the last is "with every packet".
constexpr std::array<std::uint16_t, 3> kRates{200, 100, 0xFFFF};
// A caller that does not collect the samples needs only the latest.
constexpr std::size_t kMaxSamples = 64;

}  // namespace

void MtiSession::go(Step step) noexcept {
  step_ = step;
  requested_s_.reset();
}

std::vector<Byte> MtiSession::request() const {
  switch (step_) {
    case Step::kConfigure:
      return encode_xbus(XbusId::kGotoConfig);
    case Step::kOutputs:
      return encode_xbus(XbusId::kSetOutputConfiguration,
                         encode_outputs(orientation_outputs(kRates[refused_])));
    case Step::kMeasure:
      return encode_xbus(XbusId::kGotoMeasurement);
    case Step::kMeasuring:
      break;
  }
  return {};
}

std::vector<Byte> MtiSession::due(double now_s) {
  if (woken_) {
    // After power-up it waits for a request to stay in configuration.
    woken_ = false;
    return encode_xbus(XbusId::kWakeUpAck);
  }
  if (step_ == Step::kMeasuring && now_s - received_s_ > kSilenceS) go(Step::kConfigure);
  if (step_ == Step::kMeasuring || (requested_s_ && now_s - *requested_s_ < kRepeatS)) return {};
  requested_s_ = now_s;
  return request();
}

void MtiSession::receive(std::span<const Byte> bytes, double now_s) {
  parser_.feed(bytes);
  while (const auto message = parser_.next()) take(*message, now_s);
}

void MtiSession::take(const XbusMessage& message, double now_s) {
  switch (message.id) {
    case XbusId::kWakeUp:
      woken_ = true;
      go(Step::kConfigure);
      break;
    case XbusId::kGotoConfigAck:
      if (step_ == Step::kConfigure) go(Step::kOutputs);
      break;
    case XbusId::kOutputConfiguration:
      if (step_ == Step::kOutputs) go(Step::kMeasure);
      break;
    case XbusId::kGotoMeasurementAck:
      if (step_ == Step::kMeasure) {
        go(Step::kMeasuring);
        received_s_ = now_s;
      }
      break;
    case XbusId::kError:
      if (step_ == Step::kOutputs) refused_ = std::min(refused_ + 1, kRates.size() - 1);
      break;
    case XbusId::kMtData2:
      // Before it is configured it may send other data, or at another rate.
      if (step_ != Step::kMeasuring) break;
      received_s_ = now_s;
      if (auto sample = decode_mtdata2(message.payload)) {
        if (samples_.size() == kMaxSamples) samples_.pop_front();
        samples_.push_back(*sample);
      }
      break;
    default:
      break;
  }
}

std::optional<MtSample> MtiSession::next() {
  if (samples_.empty()) return std::nullopt;
  const MtSample sample = samples_.front();
  samples_.pop_front();
  return sample;
}

}  // namespace hedgehog::device
