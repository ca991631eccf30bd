// SPDX-License-Identifier: MIT
// Effect of the coil on an aimed pin, and on the others (thesis sections 3.1.1 to 3.1.3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/design/output/picture.h"
#include "clients/design/output/table.h"
#include "clients/design/study.h"
#include "model/magnets/electromagnet.h"

namespace hedgehog::design {

struct CoilRow {
  double current_a = 0.0;
  /// By the thesis' simulation and by its measurement: force on the pin at its rest, and its
  /// extension from there, limited by the casing.
  double fea_force_n = 0.0;
  model::Stroke fea;
  double measured_force_n = 0.0;
  model::Stroke measured;
};

struct CoilStudy {
  int pin = 0;
  std::size_t class_size = 0;
  /// Rest of the pin without current, and its preload on the shell there.
  double rest_mm = 0.0;
  double preload_n = 0.0;
  std::vector<CoilRow> rows;
  std::vector<model::Activation> spread;

  /// Pins that receive at least this fraction of the aimed one's force, including that one.
  std::size_t pins_above(double fraction) const noexcept;
  std::size_t pins_pulled_in() const noexcept;
};

/// `pin`: nullopt for the first of the typical pin's class. An error if the pin does not exist or
/// is pushed out.
Result<CoilStudy> study_coil(const Study& study, std::optional<int> pin,
                             const std::vector<double>& currents_a);

Table coil_table(const CoilStudy& coil);
/// A sentence about the rest of the pin without current.
std::string standing_text(const CoilStudy& coil);
/// Force and extension against current up to `max_a`, and the spread against the angle, with the
/// thesis' values.
Result<Picture> coil_picture(const Study& study, int pin, double max_a);

}  // namespace hedgehog::design
