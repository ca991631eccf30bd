// SPDX-License-Identifier: MIT
// The verbs of hedgehog-design. Each writes its result to the screen's `out`, in its format, or
// returns an error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/design/input/design_flags.h"
#include "clients/design/output/picture.h"
#include "clients/design/screen.h"

namespace hedgehog::design {

struct ArrayOptions {
  DesignFlags design;
  /// Output file for the design.
  std::string save;
};
Result<void> run_array(const ArrayOptions& options, const Screen& screen);

struct PairOptions {
  DesignFlags design;
  std::optional<std::string> other;
  double angle_deg = 0.0;
  double offset_mm = 0.0;
};
Result<void> run_pair(const PairOptions& options, const Screen& screen);

struct CurvesOptions {
  DesignFlags design;
  std::string offsets = "-2.5..12.5/0.5";
  /// The force axis of a picture, FIRST..LAST in N, or "own": from the data of each panel. Empty:
  /// the thesis' for its six panels, otherwise "own".
  std::string forces;
  PictureFiles pictures;
};
Result<void> run_curves(const CurvesOptions& options, const Screen& screen);

struct TableOptions {
  DesignFlags design;
};
Result<void> run_table(const TableOptions& options, const Screen& screen);

struct StabilityOptions {
  DesignFlags design;
  /// Also with all pins free at once instead of one at a time.
  bool together = false;
};
Result<void> run_stability(const StabilityOptions& options, const Screen& screen);

struct ElectromagnetOptions {
  DesignFlags design;
  std::string currents = "0..15/2.5";
  /// The aimed pin; nullopt: the first of the typical pin's class.
  std::optional<int> pin;
  PictureFiles pictures;
};
Result<void> run_electromagnet(const ElectromagnetOptions& options, const Screen& screen);

struct ChooseOptions {
  std::vector<std::string> arrays;
  std::string pins = "8x10";
  std::string shields = "3..5x10";
  std::string spheres = "35..45";
  std::string coil_forces;
  double wall_mm = 0.3;
  double margin_percent = 2.0;
  double min_extension_mm = 0.5;
  int threads = 0;
  std::string save;
  PictureFiles pictures;
};
Result<void> run_choose(const ChooseOptions& options, const Screen& screen);

struct ExportOptions {
  DesignFlags design;
  /// Files; "-": the screen; nullopt: no output.
  std::optional<std::string> csv;
  std::optional<std::string> json;
  std::string scad;
  /// A folder for upper.stl and lower.stl.
  std::string stl;
  std::string device;
  int facets = 16;
  /// nullopt: as wide as the walls allow, at most 0.15 mm.
  std::optional<double> clearance_mm;
  std::optional<double> fan_mm;
};
Result<void> run_export(const ExportOptions& options, const Screen& screen);

struct ReportOptions {
  DesignFlags design;
  std::string output = "report.html";
};
Result<void> run_report(const ReportOptions& options, const Screen& screen);

}  // namespace hedgehog::design
