// SPDX-License-Identifier: MIT
#include "clients/design/output/picture.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <locale>
#include <sstream>

#include "clients/design/output/tool.h"

namespace hedgehog::design {
namespace {

// Okabe and Ito's colours, distinguishable by colour-blind people too.
constexpr std::array kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                              "#E69F00", "#56B4E9", "#000000", "#888888"};
constexpr int kPanelWidth = 620;   // 300 more if the key has two columns
constexpr int kPanelHeight = 400;  // without the key below it
constexpr int kKeyLineHeight = 18;
constexpr int kTitleHeight = 44;

/// A single-quoted gnuplot string: only the quote is special, and is doubled.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text)
    if (c == '\n')
      safe += ' ';
    else
      safe += c == '\'' ? std::string("''") : std::string(1, c);
  return safe + "'";
}

std::string style_of(const Series& series) {
  const std::string colour = std::string(" lc rgb '") +
                             kColours[static_cast<std::size_t>(series.colour) % kColours.size()] +
                             "'";
  // Ninth and further series: the same colours, dashed.
  const bool again = series.colour >= static_cast<int>(kColours.size());
  switch (series.style) {
    case Series::Style::kLine:
      return (again ? "with lines lw 2.2 dt 4" : "with lines lw 2.2") + colour;
    case Series::Style::kDashed:
      return "with lines lw 1.6 dt 2" + colour;
    case Series::Style::kMarks:
      return "with points pt 7 ps 0.9" + colour;
    case Series::Style::kCrosses:
      return "with points pt 2 ps 1.6 lw 2.5" + colour;
  }
  return "with lines";
}

void write_range(std::ostream& out, const char* axis, const Point& range) {
  if (range.x == range.y)
    out << "set " << axis << "range [*:*]\n";
  else
    out << "set " << axis << "range [" << range.x << ":" << range.y << "]\n";
}

void write_panel(std::ostream& out, const Panel& panel, std::size_t number) {
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    out << "$data_" << number << "_" << s << " << EOD\n";
    for (const Point& point : panel.series[s].points) out << point.x << " " << point.y << "\n";
    out << "EOD\n";
  }
  out << "set title " << quoted(panel.title) << " noenhanced\n";
  out << "set xlabel " << quoted(panel.x_label) << " noenhanced\n";
  out << "set ylabel " << quoted(panel.y_label) << " noenhanced\n";
  write_range(out, "x", panel.x_range);
  write_range(out, "y", panel.y_range);
  if (panel.y_tick > 0.0)
    out << "set ytics " << panel.y_tick << "\n";
  else
    out << "set ytics autofreq\n";
  out << "set offsets " << (panel.x_range.x == panel.x_range.y ? "graph 0.04, graph 0.04" : "0, 0")
      << (panel.y_range.x == panel.y_range.y ? ", graph 0.06, graph 0.06\n" : ", 0, 0\n");
  out << "unset label\n";
  for (const Note& note : panel.notes) {
    out << "set label " << quoted(note.text) << " at " << note.at.x << "," << note.at.y
        << " left noenhanced font ',10' front\n";
  }
  out << "plot ";
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const Series& series = panel.series[s];
    out << (s == 0 ? "" : ", ") << "$data_" << number << "_" << s << " using 1:2 "
        << style_of(series)
        << (series.name.empty() ? " notitle" : " title " + quoted(series.name) + " noenhanced");
  }
  out << "\n";
}

Result<void> check_drawable(const std::string& path) {
  if (!path.ends_with(".svg") && !path.ends_with(".png"))
    return Problem{kUsage, path + ": a picture's name ends in .svg or .png"};
  return check_writable(path);
}

}  // namespace

Result<void> PictureFiles::check() const {
  for (const std::string& file : {svg, png}) {
    if (file.empty()) continue;
    const auto drawable = check_drawable(file);
    if (!drawable) return drawable.error();
  }
  return {};
}

std::string gnuplot_script(const Picture& picture, const std::string& terminal,
                           const std::string& path) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(9);
  const int panels = static_cast<int>(picture.panels.size());
  const int rows = (panels + picture.columns - 1) / picture.columns;
  std::size_t key_lines = 0;
  for (const Panel& panel : picture.panels) key_lines = std::max(key_lines, panel.series.size());
  // Longer keys have two columns.
  const int key_columns = key_lines > kColours.size() ? 2 : 1;
  if (key_columns == 2) key_lines = (key_lines + 1) / 2;
  const int panel_width = kPanelWidth + (key_columns == 2 ? 300 : 0);
  const int panel_height = kPanelHeight + kKeyLineHeight * static_cast<int>(key_lines);
  out << "set encoding utf8\n"
      << "set terminal " << terminal << " size " << picture.columns * panel_width << ","
      << rows * panel_height + kTitleHeight << " font 'DejaVu Sans,11' background rgb 'white'\n"
      << "set output " << quoted(path) << "\n"
      << "set grid lc rgb '#dddddd' lt 1\n"
      << "set xzeroaxis lc rgb '#555555' lt 1 lw 1.2\n"
      << "set key at graph 0, graph -0.24 left top Left reverse maxcols " << key_columns
      << " maxrows " << key_lines
      << " samplen 2.5 spacing 1.15 "
         "noenhanced\n"
      << "set bmargin " << 4.2 + 1.2 * static_cast<double>(key_lines) << "\n"
      << "set border lc rgb '#444444'\n"
      << "set multiplot layout " << rows << "," << picture.columns << " title "
      << quoted(picture.title) << " noenhanced font ',14'\n";
  for (std::size_t p = 0; p < picture.panels.size(); ++p) write_panel(out, picture.panels[p], p);
  out << "unset multiplot\n";
  return out.str();
}

Result<void> draw(const Picture& picture, const std::string& path) {
  const auto drawable = check_drawable(path);
  if (!drawable) return drawable.error();
  // An existing file is only replaced after success.
  const auto picture_file = TemporaryFile::make(path.substr(path.size() - 4));
  if (!picture_file) return picture_file.error();
  const auto script = TemporaryFile::make(".gp");
  if (!script) return script.error();
  const std::string terminal = path.ends_with(".svg") ? "svg" : "pngcairo";
  const auto written =
      write_file(script->path(), gnuplot_script(picture, terminal, picture_file->path()));
  if (!written) return written.error();
  const auto drawn = run_tool({"gnuplot", script->path()}, "gnuplot-nox");
  if (!drawn) return drawn.error();
  const auto content = read_file(picture_file->path());
  return content ? write_file(path, *content) : content.error();
}

Result<void> draw(const Picture& picture, const PictureFiles& files) {
  for (const std::string& file : {files.svg, files.png}) {
    if (file.empty()) continue;
    const auto drawn = draw(picture, file);
    if (!drawn) return drawn.error();
  }
  return {};
}

Result<std::string> draw_svg(const Picture& picture) {
  const auto file = TemporaryFile::make(".svg");
  if (!file) return file.error();
  const auto drawn = draw(picture, file->path());
  if (!drawn) return drawn.error();
  auto text = read_file(file->path());
  if (!text) return text.error();
  const std::size_t begin = text->find("<svg");
  return begin == std::string::npos ? *text : text->substr(begin);
}

}  // namespace hedgehog::design
