// SPDX-License-Identifier: MIT
// Evaluates every design of a space, on all cores, and keeps those that meet the demands.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "clients/design/search/space.h"
#include "model/magnets/symmetry_classes.h"

namespace hedgehog::design {

struct SearchOutcome {
  std::size_t looked_at = 0;
  /// Magnets are far enough apart.
  std::size_t fit = 0;
  /// All demands are met.
  std::size_t feasible = 0;
  /// Pareto front of the feasible ones whose every pin also meets the demands with the fan's
  /// opening.
  std::vector<Found> front;
  /// Candidates of the front that do not.
  std::size_t refused_when_opened = 0;
};

/// Number of designs evaluated so far. Called by the thread that called `run`.
using Progress = std::function<void(std::size_t looked_at)>;

class Search {
 public:
  /// An error for unknown arrays, and for a sphere within the electromagnet if no coil force is
  /// given.
  static Result<Search> in(const SearchSpace& space, const Demands& demands);

  /// `threads` >= 1; all of them have ended on return.
  SearchOutcome run(int threads, const Progress& progress) const;

  const SearchSpace& space() const noexcept { return space_; }

 private:
  struct Array {
    model::Arrangement opened;
    std::vector<model::PinClass> classes;
    std::vector<model::PinClass> opened_classes;
    /// Smallest angles, degrees: pin and pin, pin and shield, shield and shield.
    double pin_pin_deg = 0.0;
    double pin_shield_deg = 0.0;
    double shield_shield_deg = 0.0;
  };
  /// Designs that share the force of pins on pins and one interpolation.
  struct Job {
    const Array* array = nullptr;
    Size pin;
    double shield_height_mm = 0.0;
    std::vector<double> diameters_mm;
    double sphere_mm = 0.0;
  };
  struct Batch {
    std::size_t fit = 0;
    std::vector<Found> found;
  };

  Search(SearchSpace space, const Demands& demands) : space_(std::move(space)), demands_(demands) {}
  std::vector<Job> jobs() const;
  Batch look(const Job& job) const;
  /// The ball as built, with its own figures; nullopt if one of its pins does not meet the demands.
  std::optional<Found> opened(const Found& found) const;
  bool fits(const Job& job, double diameter_mm) const;
  std::vector<double> coil_forces_n(const Job& job) const;

  SearchSpace space_;
  Demands demands_;
  std::vector<Array> arrays_;
};

}  // namespace hedgehog::design
