// SPDX-License-Identifier: MIT
// The flags shared by the verbs, as typed: a design file, or differences from it or from the ball
// of the thesis.
#pragma once

#include <optional>
#include <string>

#include "clients/common/problem.h"
#include "clients/design/input/design.h"

namespace hedgehog::design {

struct DesignFlags {
  std::string file;
  std::optional<std::string> array;
  std::optional<std::string> positions;
  std::optional<std::string> magnet;
  std::optional<std::string> shield;
  std::optional<double> sphere_mm;
  std::optional<double> remanence_t;
  std::optional<double> coil_force_n;
  std::optional<std::string> removed_pins;
  std::optional<std::string> removed_shields;
  std::optional<std::string> model;
  std::optional<double> accuracy;

  /// Neither a file, an array nor positions were given.
  bool names_no_array() const noexcept { return file.empty() && !array && !positions; }
};

/// Flags override the file.
Result<Design> design_from(const DesignFlags& flags);

/// "3,7-9" or "none".
Result<std::vector<int>> parse_ids(const std::string& text, const std::string& what);

}  // namespace hedgehog::design
