// SPDX-License-Identifier: MIT
#include "model/magnets/equilibrium.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "model/magnets/characterisation.h"
#include "model/magnets/symmetry_classes.h"

namespace hedgehog::model {
namespace {

/// Force on a magnet and its derivatives by its own offset and the other's.
struct Springs {
  double force_n = 0.0;
  double own_n_mm = 0.0;
  double other_n_mm = 0.0;
};

/// Cache of pairs: in a symmetric array most are equal. Key resolution is far below the required
/// accuracy.
class PairTable {
 public:
  PairTable(const MagnetPair& pair, const ForceSettings& settings)
      : pair_(pair), settings_(settings) {}

  const Springs& at(const PairPlace& place) {
    const Key key{std::llround(place.angle_deg / kSameDeg), std::llround(place.offset_mm / kSameMm),
                  std::llround(place.other_offset_mm / kSameMm)};
    const auto known = table_.find(key);
    return known != table_.end() ? known->second
                                 : table_.emplace(key, compute(place)).first->second;
  }

 private:
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  static constexpr double kSameDeg = 1e-5;
  static constexpr double kSameMm = 1e-7;
  /// Wide enough for the accuracy of the forces, narrow enough for their curvature.
  static constexpr double kStepMm = 0.02;

  Springs compute(const PairPlace& place) const {
    const auto force = [&](double own_mm, double other_mm) {
      return pair_force(
                 pair_,
                 {place.angle_deg, place.offset_mm + own_mm, place.other_offset_mm + other_mm},
                 settings_)
          .force_n;
    };
    return {force(0.0, 0.0), (force(kStepMm, 0.0) - force(-kStepMm, 0.0)) / (2.0 * kStepMm),
            (force(0.0, kStepMm) - force(0.0, -kStepMm)) / (2.0 * kStepMm)};
  }

  MagnetPair pair_;
  ForceSettings settings_;
  std::map<Key, Springs> table_;
};

struct Balance {
  Eigen::VectorXd force_n;
  /// -dF_i/do_j.
  Eigen::MatrixXd stiffness_n_mm;
};

Balance balance_at(const Arrangement& arrangement, const ArraySizes& sizes,
                   const ForceSettings& settings, const Eigen::VectorXd& offsets_mm) {
  const auto& pins = arrangement.pins;
  const auto count = static_cast<Eigen::Index>(pins.size());
  PairTable pin_pairs(sizes.pin_and_pin(), settings);
  PairTable shield_pairs(sizes.pin_and_shield(), settings);
  Balance balance{Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(count, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3& direction = pins[static_cast<std::size_t>(i)].direction;
    for (Eigen::Index k = 0; k < count; ++k) {
      if (k == i) continue;
      const double angle = angle_deg(direction, pins[static_cast<std::size_t>(k)].direction);
      const Springs& springs = pin_pairs.at({angle, offsets_mm[i], offsets_mm[k]});
      balance.force_n[i] += springs.force_n;
      balance.stiffness_n_mm(i, i) -= springs.own_n_mm;
      balance.stiffness_n_mm(i, k) -= springs.other_n_mm;
    }
    for (const MagnetSite& shield : arrangement.shields) {
      const double angle = angle_deg(direction, shield.direction);
      const Springs& springs = shield_pairs.at({angle, offsets_mm[i], 0.0});
      balance.force_n[i] -= springs.force_n;
      balance.stiffness_n_mm(i, i) += springs.own_n_mm;
    }
  }
  return balance;
}

/// Rest position of each pin with the others fixed at 0; 0 if it has none.
Eigen::VectorXd rests_alone(const Arrangement& arrangement, const ArraySizes& sizes) {
  // Initial guess only.
  const ForceSettings rough{ForceModel::kExact, 1e-3};
  Eigen::VectorXd offsets =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arrangement.pins.size()));
  for (const PinClass& pin_class : symmetry_classes(arrangement)) {
    const auto character = characterise(PinForce(pin_class, sizes, rough), {-1.5, 2.5, 0.5});
    for (std::size_t i = 0; i < arrangement.pins.size(); ++i)
      if (std::binary_search(pin_class.pins.begin(), pin_class.pins.end(), arrangement.pins[i].id))
        offsets[static_cast<Eigen::Index>(i)] = character.rest_mm.value_or(0.0);
  }
  return offsets;
}

}  // namespace

MagnetResult<Equilibrium> find_equilibrium(const Arrangement& arrangement, const ArraySizes& sizes,
                                           const ForceSettings& settings,
                                           std::span<const double> coil_force_n) {
  constexpr int kMaxDescents = 30;
  constexpr double kSettledMm = 1e-6;
  constexpr double kLongestStepMm = 0.5;
  constexpr double kFarthestMm = 10.0;
  if (auto error = check_fit(arrangement, sizes)) return *error;
  if (arrangement.pins.empty()) return MagnetError{"the array has no pins"};
  if (!coil_force_n.empty() && coil_force_n.size() != arrangement.pins.size()) {
    return MagnetError{"there must be one coil force for each of the " +
                       std::to_string(arrangement.pins.size()) + " pins"};
  }
  Eigen::VectorXd push = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(arrangement.pins.size()));
  if (!coil_force_n.empty())
    push = Eigen::Map<const Eigen::VectorXd>(coil_force_n.data(), push.size());
  Eigen::VectorXd offsets = rests_alone(arrangement, sizes);
  for (int i = 1; i <= kMaxDescents; ++i) {
    const Balance balance = balance_at(arrangement, sizes, settings, offsets);
    const Eigen::VectorXd force = balance.force_n + push;
    Eigen::VectorXd step = balance.stiffness_n_mm.partialPivLu().solve(force);
    const double longest = step.cwiseAbs().maxCoeff();
    if (!std::isfinite(longest)) break;
    if (longest < kSettledMm) {
      // -dF/do is the Hessian of an energy: its asymmetry is rounding error.
      const Eigen::MatrixXd symmetric =
          0.5 * (balance.stiffness_n_mm + balance.stiffness_n_mm.transpose());
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric,
                                                                  Eigen::EigenvaluesOnly);
      Equilibrium found;
      found.offsets_mm.assign(offsets.begin(), offsets.end());
      found.stiffness_n_mm.assign(solver.eigenvalues().begin(), solver.eigenvalues().end());
      found.residual_n = force.cwiseAbs().maxCoeff();
      found.iterations = i;
      return found;
    }
    offsets += std::min(1.0, kLongestStepMm / longest) * step;
    if (offsets.cwiseAbs().maxCoeff() > kFarthestMm) break;
  }
  return MagnetError{"no position was found in which all pins of '" + arrangement.name +
                     "' are at rest together"};
}

}  // namespace hedgehog::model
