// SPDX-License-Identifier: MIT
// Curves with axes, drawn by gnuplot as SVG or PNG.
#pragma once

#include <string>
#include <vector>

#include "clients/common/problem.h"

namespace hedgehog::design {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Series {
  enum class Style { kLine, kDashed, kMarks, kCrosses };
  /// In the key; empty: not there.
  std::string name;
  std::vector<Point> points;
  Style style = Style::kLine;
  /// Which of the eight colours: series that belong together share one. From 8 on lines are broken.
  int colour = 0;
};

/// Words at a place, in the units of the axes.
struct Note {
  std::string text;
  Point at;
};

/// One pair of axes.
struct Panel {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  std::vector<Note> notes;
  /// From where to where the axes go; equal ends: as the data are.
  Point x_range{0, 0};
  Point y_range{0, 0};
  /// Between the numbers at the y axis; 0: as gnuplot chooses.
  double y_tick = 0.0;
};

struct Picture {
  std::string title;
  std::vector<Panel> panels;
  int columns = 1;
};

/// Where a picture goes; empty: not there.
struct PictureFiles {
  std::string svg;
  std::string png;

  /// Complains as `draw` would of the names and places, before long work.
  Result<void> check() const;
};

/// As SVG when `path` ends in ".svg", as PNG when it ends in ".png"; a complaint otherwise, and
/// when gnuplot is missing or refuses.
Result<void> draw(const Picture& picture, const std::string& path);

/// Into the files that are named.
Result<void> draw(const Picture& picture, const PictureFiles& files);

/// The SVG as text, to be put into HTML.
Result<std::string> draw_svg(const Picture& picture);

/// What gnuplot is told (for tests).
std::string gnuplot_script(const Picture& picture, const std::string& terminal,
                           const std::string& path);

}  // namespace hedgehog::design
