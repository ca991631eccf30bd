// SPDX-License-Identifier: MIT
#include "clients/design/command_line.h"

#include <functional>

#include "cli/program.h"
#include "clients/design/verbs/verbs.h"

namespace hedgehog::design {
namespace {

constexpr const char* kFooter =
    "Sizes are mm and degrees, magnets DIAMETERxHEIGHT. Defaults are those of the\n"
    "thesis' ball: tkD-86, pins 8x10, shields 4x10, inner faces on a sphere of\n"
    "35 mm, N45, a coil of 0.4 N.\n"
    "Exit: 0 done, 64 usage, 65 bad data or magnets that overlap, 66 no such file,\n"
    "69 gnuplot or openscad missing, 73 a file cannot be written, 74 gnuplot or\n"
    "openscad failed.";

class CommandLine {
 public:
  CommandLine(std::ostream& out, std::ostream& err) : out_(out), err_(err) {
    app_.require_commands(1, 1);
    app_.set_version(std::string("hedgehog-design " HEDGEHOG_VERSION));
    app_.set_footer(kFooter);
    add_looking();
    add_computing();
    add_making();
  }

  int run(const std::vector<std::string>& arguments) {
    if (const auto ended = app_.parse(arguments)) {
      if (ended->code == kUsage)
        err_ << ended->text << "\n";
      else
        out_ << ended->text;
      return ended->code;
    }
    const Format format = json_ ? Format::kJson : csv_ ? Format::kCsv : Format::kText;
    const auto done = verb_({out_, err_, format});
    out_.flush();
    if (done && out_) return kDone;
    if (done) {
      err_ << "hedgehog-design: the answer cannot be written\n";
      return kCannotCreate;
    }
    err_ << "hedgehog-design: " << done.error().message << "\n";
    return done.error().exit_code;
  }

 private:
  using Verb = std::function<Result<void>(const Screen&)>;

  template <class Options>
  cli::CommandSpec verb(const std::string& name, const std::string& help, Options& options,
                        Result<void> (*act)(const Options&, const Screen&)) {
    const cli::CommandSpec command = app_.add_command(name, help);
    command.on_given([this, &options, act] {
      verb_ = [&options, act](const Screen& screen) { return act(options, screen); };
    });
    return command;
  }

  void add_formats(const cli::CommandSpec& command) {
    const auto json = command.add_flag("--json", json_, "the answer as JSON");
    command.add_flag("--csv", csv_, "the answer as CSV").excludes(json);
  }

  static void add_pictures(const cli::CommandSpec& command, PictureFiles& files) {
    command.add_option("--svg", files.svg, "draw a picture into this file (gnuplot)");
    command.add_option("--png", files.png, "the same as PNG");
  }

  static void add_magnets(const cli::CommandSpec& command, DesignFlags& flags) {
    command.add_option("file", flags.file, "a design file, instead of flags");
    command.add_option("--magnet", flags.magnet, "the pins' magnets, such as 8x10");
    command.add_option("--sphere", flags.sphere_mm, "radius on which the inner faces are, mm");
    command.add_option("--remanence", flags.remanence_t, "of all magnets, tesla (N45: 1.37)");
    command.add_option("--model", flags.model, "exact, hybrid (dipoles from 30° on) or dipole");
    command.add_option("--accuracy", flags.accuracy, "of each pair's force, 1e-10 to 0.1");
  }

  static void add_design(const cli::CommandSpec& command, DesignFlags& flags) {
    add_magnets(command, flags);
    command.add_option("--array", flags.array,
                       "D, tI, cD, wD, tkD, GP(m,n); tkD-86: with an opening");
    command.add_option("--positions", flags.positions, "a CSV (kind,x,y,z) instead of an array");
    command.add_option("--shield", flags.shield, "the shields' magnets, such as 4x10");
    command.add_option("--remove-pins", flags.removed_pins, "ids, such as 3,7-9");
    command.add_option("--remove-shields", flags.removed_shields, "ids, such as 3,7-9");
    command.add_option("--coil-force", flags.coil_force_n, "what pushes an aimed pin, N");
  }

  void add_looking() {
    const auto array =
        verb("array", "where the magnets are, how far apart, how heavy", array_, run_array);
    add_design(array, array_.design);
    add_formats(array);
    array.add_option("--save", array_.save, "write the design into this file");
    const auto pair =
        verb("pair", "the force between two magnets, by three models", pair_, run_pair);
    add_magnets(pair, pair_.design);
    add_formats(pair);
    pair.add_option("--other", pair_.other, "the magnet that acts on --magnet, such as 4x10");
    pair.add_option("--angle", pair_.angle_deg, "between them, seen from the centre, degrees")
        .required();
    pair.add_option("--offset", pair_.offset_mm, "of --magnet, outwards, mm");
  }

  void add_computing() {
    const auto curves =
        verb("curves", "force against offset; alone: thesis Fig. 2.10", curves_, run_curves);
    add_design(curves, curves_.design);
    add_formats(curves);
    add_pictures(curves, curves_.pictures);
    curves.add_option("--offsets", curves_.offsets, "FIRST..LAST/STEP, mm").show_default();
    curves.add_option("--forces", curves_.forces,
                      "a picture's force axis: FIRST..LAST, N, or own for each panel's");
    const auto table =
        verb("table", "how far pins move, beside the thesis (Table 2.1)", table_, run_table);
    add_design(table, table_.design);
    add_formats(table);
    const auto stability = verb("stability", "checks that every pin has a stable rest position",
                                stability_, run_stability);
    add_design(stability, stability_.design);
    add_formats(stability);
    stability.add_flag("--together", stability_.together, "also with all pins free at once");
    const auto coil = verb("electromagnet", "force and extension against current; the spread",
                           coil_, run_electromagnet);
    add_design(coil, coil_.design);
    add_formats(coil);
    add_pictures(coil, coil_.pictures);
    coil.add_option("--current", coil_.currents, "FIRST..LAST/STEP, A").show_default();
    coil.add_option("--pin", coil_.pin, "the pin that is aimed at");
  }

  void add_making() {
    const auto choose = verb("choose", "search for Pareto-optimal designs", choose_, run_choose);
    add_formats(choose);
    add_pictures(choose, choose_.pictures);
    choose.add_option("--arrays", choose_.arrays, "whole arrays; from 32 to 162 faces by default");
    choose.add_option("--pins", choose_.pins, "sizes, such as 7..9/0.5x8..12").show_default();
    choose.add_option("--shields", choose_.shields, "sizes, diameters in steps of 0.05")
        .show_default();
    choose.add_option("--spheres", choose_.spheres, "radii, mm, in steps of 0.25").show_default();
    choose.add_option("--coil-force", choose_.coil_forces,
                      "N; by default that of the thesis' coil at 15 A");
    choose.add_option("--wall", choose_.wall_mm, "between any two magnets, mm, 0 to 20")
        .show_default();
    choose
        .add_option("--margin", choose_.margin_percent,
                    "how much weaker all shields may be, %, 0 to 50")
        .show_default();
    choose
        .add_option("--least-extension", choose_.min_extension_mm,
                    "of the typical pin, mm, 0 to 1.5")
        .show_default();
    choose.add_option("--threads", choose_.threads, "all cores by default").range(1, 256);
    choose.add_option("--save", choose_.save, "write the best into this design file");
    const auto exports =
        verb("export", "positions, casing to print, device file", export_, run_export);
    add_design(exports, export_.design);
    exports.add_option("--csv", export_.csv, "positions as CSV, into a file or here")
        .optional_value();
    exports.add_option("--json", export_.json, "positions as JSON, into a file or here")
        .optional_value();
    exports.add_option("--scad", export_.scad, "the casing as an OpenSCAD model");
    exports.add_option("--stl", export_.stl, "a folder for upper.stl and lower.stl (openscad)");
    exports.add_option("--device", export_.device, "a device file for hedgehogd");
    exports.add_option("--facets", export_.facets, "sides of a cavity, 8 to 64").show_default();
    exports.add_option("--clearance", export_.clearance_mm,
                       "around each magnet, mm; 0.15, less for walls of 0.2, by default");
    exports.add_option("--fan", export_.fan_mm, "opening at the bottom, mm; the widest by default");
    const auto report =
        verb("report", "everything about a design on one HTML page", report_, run_report);
    add_design(report, report_.design);
    report.add_option("--output", report_.output, "the file").show_default();
  }

  std::ostream& out_;
  std::ostream& err_;
  cli::Program app_{
      "The array designer: where magnets go, whether the pins hold, how far they move.",
      "hedgehog-design"};
  Verb verb_;
  bool json_ = false;
  bool csv_ = false;
  ArrayOptions array_;
  PairOptions pair_;
  CurvesOptions curves_;
  TableOptions table_;
  StabilityOptions stability_;
  ElectromagnetOptions coil_;
  ChooseOptions choose_;
  ExportOptions export_;
  ReportOptions report_;
};

}  // namespace

int run_command_line(const std::vector<std::string>& arguments, std::ostream& out,
                     std::ostream& err) {
  return CommandLine(out, err).run(arguments);
}

}  // namespace hedgehog::design
