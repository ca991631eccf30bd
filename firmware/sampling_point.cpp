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
      (kSampledAfterNs - kInputLagNs) * kCyclesPerUs / 1000;
  reg(kPwmWrapInterrupts) = kWrap;
}

void wait_for_sampling_point() noexcept {
  // A host's packets would wake the processor again and again.
  const Wakeups only(kPwmInterrupt);
  reg(kPwmWraps) = kWrap;
  only.clear();
  while ((reg(kPwmWraps) & kWrap) == 0) only.sleep();
}

}  // namespace hedgehog::firmware
