// SPDX-License-Identifier: MIT
// Plots with axes, drawn by gnuplot as SVG or PNG.
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
  /// In the key; empty: not shown.
  std::string name;
  std::vector<Point> points;
  Style style = Style::kLine;
  /// Index of one of eight colours, shared by related series. From 8 on lines are dashed.
  int colour = 0;
};

/// A label at a position, in the units of the axes.
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
  /// Ranges of the axes; equal ends: from the data.
  Point x_range{0, 0};
  Point y_range{0, 0};
  /// Distance of the numbers at the y axis; 0: chosen by gnuplot.
  double y_tick = 0.0;
};

struct Picture {
  std::string title;
  std::vector<Panel> panels;
  int columns = 1;
};

/// Output files of a picture; empty: none.
struct PictureFiles {
  std::string svg;
  std::string png;

  /// Checks the file names as `draw` does, before a long computation.
  Result<void> check() const;
};

/// As SVG if `path` ends in ".svg", as PNG if it ends in ".png"; otherwise an error, also if
/// gnuplot is missing or fails.
Result<void> draw(const Picture& picture, const std::string& path);

/// Draws into the files that are set.
Result<void> draw(const Picture& picture, const PictureFiles& files);

/// The SVG as text, for embedding in HTML.
Result<std::string> draw_svg(const Picture& picture);

/// The script for gnuplot (for tests).
std::string gnuplot_script(const Picture& picture, const std::string& terminal,
                           const std::string& path);

}  // namespace hedgehog::design
