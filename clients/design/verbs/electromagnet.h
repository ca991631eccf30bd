// SPDX-License-Identifier: MIT
// What the coil does to one pin, and to the others meanwhile (thesis sections 3.1.1 to 3.1.3).
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
  /// By the thesis' simulation and by its measurement: force on the pin at its rest, and how far it
  /// moves from there, at most to the casing.
  double fea_force_n = 0.0;
  model::Stroke fea;
  double measured_force_n = 0.0;
  model::Stroke measured;
};

struct CoilStudy {
  int pin = 0;
  std::size_t class_size = 0;
  /// Where the pin is without current, and with how much it is pressed onto the shell there.
  double rest_mm = 0.0;
  double preload_n = 0.0;
  std::vector<CoilRow> rows;
  std::vector<model::Activation> spread;

  /// Pins that get at least this part of what the aimed one gets, itself counted.
  std::size_t pins_above(double fraction) const noexcept;
  std::size_t pins_pulled_in() const noexcept;
};

/// `pin`: none for the first of the typical pin's class. Complains when there is no such pin, or
/// when it is pushed out.
Result<CoilStudy> study_coil(const Study& study, std::optional<int> pin,
                             const std::vector<double>& currents_a);

Table coil_table(const CoilStudy& coil);
/// Where the pin is without current: a sentence.
std::string standing_text(const CoilStudy& coil);
/// Force and extension against current up to `max_a`, and the spread against the angle, with the
/// thesis' values.
Result<Picture> coil_picture(const Study& study, int pin, double max_a);

}  // namespace hedgehog::design
