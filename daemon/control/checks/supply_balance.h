// SPDX-License-Identifier: MIT
// Supply current against the sum of duty times winding current, which the bridges draw. Independent
// sensors: detects a changed gain of a winding current, which to V/I is a changed resistance.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/disagreement.h"
#include "model/coils.h"
#include "model/estimate/current_accuracy.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// Inputs of one tick. Trivially copyable.
struct SupplyReading {
  bool known = false;  // new telemetry in which all of these were measured
  model::Vec3 duty;
  model::Vec3 current_a;
  double supply_current_a = 0.0;
  double supply_v = 12.0;
  model::CurrentAccuracy accuracy;
};

/// Control thread; real-time safe, trivially copyable.
class SupplyBalance {
 public:
  static constexpr double kMinSumA = 1.0;  // smallest sum that is checked
  static constexpr double kGain = 0.045;   // tolerated gain difference, winding to supply current
  static constexpr double kHoldS = 0.3;
  static constexpr double kGainHoldS = 0.5;
  /// Maximum age of the last measured window; at the trip temperature the limiter ends the current.
  static constexpr double kMaxLastAgeS = 0.1;

  SupplyBalance() noexcept : SupplyBalance(model::CoilModel{}.supply_v) {}
  explicit SupplyBalance(double nominal_supply_v) noexcept;

  /// Advances by `dt_s`. The winding whose current contradicts the supply current, or none.
  Disagreement step(const SupplyReading& reading, double dt_s) noexcept;

  /// The quantity that changed when V/I of winding `coil` has changed by `share` since the start or
  /// against the device file; or the two that cannot be distinguished, also without a measured
  /// supply. By means over 0.3 s, or by the last measured window of 20 ms for a younger change.
  enum class Since : std::uint8_t { kStart, kFile };
  enum class By : std::uint8_t { kMeans, kLastWindow };
  Disagreement moved(int coil, double share, Since since, By by = By::kMeans) const noexcept;

  /// Share by which winding `coil` reads high against the supply current; its standard deviation.
  double gain(int coil) const noexcept;
  double gain_deviation(int coil) const noexcept;

 private:
  // `gain` of each winding, then the offset of the supply current, A.
  static constexpr std::size_t kOffset = model::kCoils;
  static constexpr std::size_t kStates = kOffset + 1;
  using Row = std::array<double, kStates>;

  /// Sums over some ticks.
  struct Window {
    double s = 0.0;
    int readings = 0;
    std::array<double, model::kCoils> part_a{};
    double duty_squared = 0.0;
    double supply_a = 0.0;
    double supply_v = 0.0;
  };

  Disagreement check(double dt_s) noexcept;
  void update(const Row& derivative, double variance, double difference_a) noexcept;
  /// Magnitude of `gain` less two standard deviations; the winding with the highest.
  double certain_gain(int coil) const noexcept;
  int worst() const noexcept;
  void remember(const Row& derivative) noexcept;

  double nominal_supply_v_ = 12.0;
  Window window_;
  model::CurrentAccuracy accuracy_;
  Row x_{};
  std::array<Row, kStates> p_{};
  Row derivative_{};
  FaultDebounce odd_, apart_;

  /// Supply current beyond the sum, the sum's parts by winding, and the supply's open voltage.
  struct Balance {
    double missing_a = 0.0;
    std::array<double, model::kCoils> part_a{};
    double supply_v = 0.0;
  };

  // Of the first seconds: gains, their deviations, supply voltage.
  double observed_s_ = 0.0;
  Row first_{};
  std::array<double, model::kCoils> first_deviation_{};
  double first_supply_v_ = 0.0;
  Balance mean_, last_;
  double last_age_s_ = 0.0;
};

}  // namespace hedgehog::control
