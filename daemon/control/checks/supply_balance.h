// SPDX-License-Identifier: MIT
// The supply's current against the sum of duty times winding current, which the bridges draw. The
// two are measured by different sensors, so a winding current whose gain has moved shows here,
// where V/I cannot tell it from a resistance.
#pragma once

#include <array>
#include <cstdint>

#include "daemon/control/checks/fault_debounce.h"
#include "daemon/control/state/disagreement.h"
#include "model/coils.h"
#include "model/estimate/current_accuracy.h"
#include "model/vec3.h"

namespace hedgehog::control {

/// One tick of what it sees. Trivially copyable.
struct SupplyReading {
  /// New telemetry in which all of it was measured.
  bool known = false;
  model::Vec3 duty;
  model::Vec3 current_a;
  double supply_current_a = 0.0;
  double supply_v = 12.0;
  model::CurrentAccuracy accuracy;
};

/// Control thread; real-time safe, trivially copyable.
class SupplyBalance {
 public:
  /// The smallest sum that is judged, A.
  static constexpr double kMinSumA = 1.0;
  /// Gains of the currents against the supply's that are further apart are no tolerance any more.
  static constexpr double kGain = 0.045;
  static constexpr double kHoldS = 0.3;
  static constexpr double kGainHoldS = 0.5;

  SupplyBalance() noexcept : SupplyBalance(model::CoilModel{}.supply_v) {}
  explicit SupplyBalance(double nominal_supply_v) noexcept;

  /// `dt_s` later. The winding whose current contradicts the supply's, or none.
  Disagreement step(const SupplyReading& reading, double dt_s) noexcept;

  /// V/I of winding `coil` has moved by `share` since the start, or is off by it from the device
  /// file: against which other quantity, or which of two it may have been.
  enum class Since : std::uint8_t { kStart, kFile };
  Disagreement moved(int coil, double share, Since since) const noexcept;

  /// By how much winding `coil` reads high against the supply's current, a share, and the standard
  /// deviation of that.
  double gain(int coil) const noexcept;
  double gain_deviation(int coil) const noexcept;

 private:
  // By winding, how much its current reads high against the supply's; then the offset of that, A.
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

  Disagreement judge(double dt_s) noexcept;
  void learn(const Row& derivative, double variance, double difference_a) noexcept;
  int worst() const noexcept;
  void remember(const Row& derivative) noexcept;

  double nominal_supply_v_ = 12.0;
  Window window_;
  model::CurrentAccuracy accuracy_;
  Row x_{};
  std::array<Row, kStates> p_{};
  Row derivative_{};
  FaultDebounce odd_, apart_;

  // Lately: what the supply delivers beyond the first gains, by winding what it carries, its
  // voltage; and the gains and the voltage at first.
  double learned_s_ = 0.0;
  Row first_{};
  std::array<double, model::kCoils> first_deviation_{};
  double first_supply_v_ = 0.0;
  double lately_missing_a_ = 0.0;
  std::array<double, model::kCoils> lately_part_a_{};
  double lately_supply_v_ = 0.0;
};

}  // namespace hedgehog::control
