// SPDX-License-Identifier: MIT
#include "firmware/sampling_point.h"

#include "firmware/pico_wiring.h"
#include "firmware/registers.h"
#include "firmware/sleep.h"

namespace hedgehog::firmware {
namespace {

constexpr uint32_t kWrap = 1u << kSamplingSlice;
constexpr uint32_t kCyclesPerUs = 125;

}  // namespace

void prepare_sampling_points() noexcept {
  reg(pwm_slice(kSamplingSlice) + kPwmWrapValue) = kPwmPeriod - 1;
  // Ahead of the bridges' counters.
  reg(pwm_slice(kSamplingSlice) + kPwmCounter) =
      (kSampledAfterNs - kInputDelayNs) * kCyclesPerUs / 1000;
  reg(kPwmWrapInterrupts) = kWrap;
}

void clear_sampling_point() noexcept { reg(kPwmWraps) = kWrap; }

void wait_for_sampling_point() noexcept {
  const Wakeups wakeups(kPwmInterrupt);
  wakeups.clear();
  while ((reg(kPwmWraps) & kWrap) == 0) wakeups.sleep();
  clear_sampling_point();
}

}  // namespace hedgehog::firmware
