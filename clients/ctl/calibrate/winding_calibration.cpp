// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/winding_calibration.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "clients/common/interrupts.h"
#include "clients/ctl/calibrate/felt_sides.h"
#include "clients/ctl/calibrate/rest_check.h"
#include "clients/ctl/calibrate/winding_bench.h"
#include "clients/ctl/terminal/words.h"
#include "model/coils.h"

namespace hedgehog::client {
namespace {

constexpr double kFrequencyHz = 47.0;
constexpr double kSineS = 1.2;
/// Of the inductance; what the file has is the mean of three windings.
constexpr double kMaxInductanceError = 0.01;
/// Current of the first check of an unknown winding, A: too small for the watchdog to detect a
/// fault in a winding with a third of its resistance, reversed or swapped.
constexpr double kCheckA = 0.3;
constexpr double kCheckS = 0.2;
constexpr double kTakeS = 0.6;
/// Of the mean current in each direction; that of the resistance is smaller by the root of two.
constexpr double kMaxError = 0.004;
/// Below 1.5 A a wrong resistance cannot be mistaken for heat.
constexpr double kUnknownA = 1.2;
/// A clearly perceptible push, A; only if the daemon's resistance is accurate to `kKnown`.
constexpr double kPushA = 3.0;
constexpr double kKnown = 0.03;
/// Above the spread of windings of one kind.
constexpr double kOdd = 0.25;
/// Duration of a measurement of each winding in each direction, s.
constexpr double kMeasureS = 1.5;
/// Relative standard deviations of R25: of a ball measured at rest; of one whose device file was
/// too inaccurate for two measurements.
constexpr double kMeasuredShare = 0.01;
constexpr double kGuessedShare = 0.03;

/// A trip caused by a resistance far from the device file's; any other trip, a refusal or a lost
/// connection is unrelated to the winding.
bool is_resistance_trip(std::string_view reason) {
  return reason == "current_mismatch" || reason == "sensor_frozen" || reason == "sensor_disagrees";
}

class Windings {
 public:
  Windings(Session& session, const CalibrateOptions& options, PushedSides pushed,
           const protocol::Description& before)
      : bench_(session), options_(options), before_(before), text_(session.json ? stderr : stdout) {
    interactive_ = !session.json && options.pushed.empty() && isatty(STDIN_FILENO) != 0;
    found_.pushed = std::move(pushed);
    found_.name = options.name.empty() ? before.name : options.name;
  }

  int run() {
    if (before_.gain < 1.0) {
      return print_error("the gain is " + fixed(before_.gain, 2) +
                         " and would weaken every current; run: hedgehogctl gain 1");
    }
    const auto rest = bench_.rest();
    if (!rest) return give_up(rest.error());
    if (const int code = accept(rest_deviation(rest->temperature_c, before_.thermal));
        code != kDone)
      return code;
    std::fprintf(
        text_, "%s: one winding at a time, never more than %s A.\nCtrl-C switches the coils off.\n",
        before_.name.c_str(),
        fixed(interactive_ ? std::max(options_.current_a, kPushA) : options_.current_a, 1).c_str());
    found_.sensor_c = reference_c(rest->temperature_c);
    for (int coil = 0; coil < 3; ++coil)
      if (const int code = measure(coil); code != kDone) return code;
    if (const int code = measure_all(first_); code != kDone) return code;
    if (const int code = determine_sides(); code != kDone) return code;
    if (const int code = measure_again(); code != kDone) return code;
    return kDone;
  }

  const Calibration& found() const { return found_; }

 private:
  /// Rejects a ball that is not at one temperature, or stores its possible deviation.
  int accept(const RestDeviation& unrest) {
    if (!unrest.any()) return kDone;
    const double wrong = 100.0 * model::kCopperPerKelvin * unrest.apart_k;
    const std::string what = "the ball is not at one temperature: " + unrest.what +
                             ". r25_ohm may be " + fixed(wrong, 1) + " % wrong";
    if (!options_.force) {
      print_error(what + ". Let the ball rest for " + minutes_text(unrest.wait_s) +
                  " and calibrate again; --force writes it all the same, with a wider uncertainty");
      return kTryLater;
    }
    std::fprintf(text_, "Forced: %s.\n", what.c_str());
    found_.unrest = unrest.what;
    found_.apart_k = std::max(found_.apart_k, unrest.apart_k);
    return kDone;
  }

  static double r25_at(const WindingMeasurement& look, std::size_t i) {
    return look.resistance_ohm[i] / (1.0 + model::kCopperPerKelvin * (look.reference_c - 25.0));
  }

  bool all_known() const {
    return resistance_known(0) && resistance_known(1) && resistance_known(2);
  }

  /// Measures all windings once, with a current that is only allowed for known resistances.
  int measure_all(WindingMeasurement& look) {
    if (!all_known()) return kDone;
    for (int coil = 0; coil < 3; ++coil) {
      const auto seen = steady(coil, kPushA, {kMeasureS});
      if (!seen) return give_up(seen.error());
      if (const auto problem = problem_of(coil, *seen); !problem.empty())
        return print_error(problem);
      const auto i = static_cast<std::size_t>(coil);
      look.resistance_ohm[i] = *seen->resistance_ohm;
      look.error[i] = steady_resistance_error(seen->forth.samples, seen->back.samples);
    }
    const auto rest = bench_.rest();
    if (!rest) return give_up(rest.error());
    look.t_s = 1e-9 * static_cast<double>(rest->time_ns);
    look.reference_c = reference_c(rest->temperature_c);
    return kDone;
  }

  int measure_again() {
    found_.resistance_share = kGuessedShare;
    if (!all_known()) return kDone;
    std::fprintf(text_, "Second measurement of the windings, %s s after the first.\n",
                 fixed(kMinIntervalS, 0).c_str());
    std::fflush(text_);
    if (auto waited = bench_.wait_until(first_.t_s + kMinIntervalS); !waited)
      return give_up(waited.error());
    WindingMeasurement second;
    if (const int code = measure_all(second); code != kDone) return code;
    if (const int code = accept(drift_of(first_, second)); code != kDone) return code;
    if (found_.unrest.empty()) found_.resistance_share = kMeasuredShare;
    // Measured with more current and time than the first measurement.
    for (std::size_t i = 0; i < 3; ++i)
      found_.r25_ohm[i] = 0.5 * (r25_at(first_, i) + r25_at(second, i));
    return kDone;
  }

  struct Steady {
    WindingRecord forth, back;
    std::optional<double> resistance_ohm;
  };
  Outcome<Steady> steady(int coil, double current_a, WindingBench::Extent extent) {
    auto forth = bench_.hold(coil, 1.0, current_a, extent);
    if (!forth) return forth.error();
    auto back = bench_.hold(coil, -1.0, current_a, extent);
    if (!back) return back.error();
    const auto resistance = steady_resistance(forth->samples, back->samples);
    return Steady{*std::move(forth), *std::move(back), resistance};
  }

  static std::string problem_of(int coil, const Steady& seen) {
    return winding_problem(coil, seen.forth.mean_a, seen.back.mean_a, seen.resistance_ohm);
  }

  int measure(int coil) {
    const auto i = static_cast<std::size_t>(coil);
    const auto probe = steady(coil, kCheckA, {kCheckS});
    if (!probe) return fail_probe(coil, probe.error());
    if (const auto problem = problem_of(coil, *probe); !problem.empty())
      return print_error(problem);
    const double expected_ohm = at_rest(before_.coils.r25_ohm[i]);
    const double ratio = *probe->resistance_ohm / expected_ohm;
    const bool known = std::abs(ratio - 1.0) < kKnown;
    // The daemon computes with its own resistance, so a lower one results in more current.
    const double current_a =
        (known ? options_.current_a : std::min(options_.current_a, kUnknownA)) *
        std::min(1.0, ratio);
    const auto seen = steady(coil, current_a, {kTakeS, kMaxError});
    if (!seen) return give_up(seen.error());
    if (const auto problem = problem_of(coil, *seen); !problem.empty()) return print_error(problem);
    const auto sine = bench_.sine(coil, current_a, kFrequencyHz, {kSineS, kMaxInductanceError});
    if (!sine) return give_up(sine.error());
    const auto impedance = sine_impedance(sine->samples, kFrequencyHz);
    if (!impedance) {
      return print_error("the current of winding " + std::string(1, kAxisNames[coil]) +
                         " does not follow the voltage");
    }
    const double resistance_ohm = *seen->resistance_ohm;
    found_.r25_ohm[i] = resistance_ohm / at_rest(1.0);
    found_.inductance_h[i] = impedance->inductance_h;
    found_.supply_v = seen->forth.supply_v;
    found_.current_a = std::max(found_.current_a, std::abs(seen->forth.mean_a[i]));
    std::fprintf(text_, "  %c  %s ohm at %s °C, %s at 25 °C   %s mH   current as commanded\n",
                 kAxisNames[coil], fixed(resistance_ohm, 4).c_str(),
                 fixed(found_.sensor_c, 1).c_str(), fixed(found_.r25_ohm[i], 4).c_str(),
                 fixed(1000.0 * found_.inductance_h[i], 3).c_str());
    if (const double error = inductance_error(sine->samples, kFrequencyHz);
        error > kMaxInductanceError) {
      const std::string percent = std::isinf(error) ? "unknown" : fixed(100.0 * error, 1) + " %";
      std::fprintf(text_,
                   "     The inductance's standard deviation is %s: too little telemetry, or a "
                   "noisy current sensor.\n",
                   percent.c_str());
    }
    if (std::abs(found_.r25_ohm[i] / before_.coils.r25_ohm[i] - 1.0) > kOdd) {
      std::fprintf(
          text_,
          "     The present device file has %s: another winding, a bad contact or a short?\n",
          fixed(before_.coils.r25_ohm[i], 4).c_str());
    }
    std::fflush(text_);
    return kDone;
  }

  /// A resistance at 25 C converted to the present temperature.
  double at_rest(double r25_ohm) const {
    return r25_ohm * (1.0 + model::kCopperPerKelvin * (found_.sensor_c - 25.0));
  }

  int fail_probe(int coil, const ClientError& error) const {
    const int code = give_up(error);
    if (interrupted() || !is_resistance_trip(bench_.tripped().value_or(""))) return code;
    std::ostringstream text;
    text << "winding " << kAxisNames[coil] << " was driven with " << fixed(kCheckA, 1)
         << " A. If all plugs are right it has less than a quarter of the "
         << fixed(before_.coils.r25_ohm[static_cast<std::size_t>(coil)], 2)
         << " ohm in the device file: measure it by hand, write it there (r25_ohm), restart "
            "hedgehogd and calibrate again";
    return print_error(text.str());
  }

  bool resistance_known(std::size_t winding) const {
    return std::abs(found_.r25_ohm[winding] / before_.coils.r25_ohm[winding] - 1.0) < kKnown;
  }

  int determine_sides() {
    if (!interactive_) {
      if (!coil_matrix(found_.pushed))
        std::fputs("The coil matrix is unchanged: the sides were not given (--pushed).\n", text_);
      return kDone;
    }
    if (!all_known()) {
      std::fputs(
          "The coil matrix is unchanged: the resistances in force are too far from these\n"
          "for a push that can be felt. Start hedgehogd with the new file, then calibrate\n"
          "once more: you will be asked which side each winding pushes.\n",
          text_);
      return kDone;
    }
    auto felt = prompt_sides(bench_, kPushA);
    if (!felt) return give_up(felt.error());
    found_.pushed = *std::move(felt);
    return kDone;
  }

  WindingBench bench_;
  const CalibrateOptions& options_;
  const protocol::Description& before_;
  Calibration found_;
  WindingMeasurement first_;
  /// For users; stderr if stdout is JSON.
  std::FILE* text_;
  /// The user can be asked for the sides, and they are not given yet.
  bool interactive_ = false;
};

}  // namespace

int print_error(const std::string& what) {
  print_failure("failed", "calibrate: " + what);
  return kEndedOtherwise;
}

int give_up(const ClientError& error) {
  if (!interrupted()) return report_error(error);
  std::fputs("hedgehogctl calibrate: interrupted; the coils are off, nothing was written\n",
             stderr);
  return kInterrupted;
}

int calibrate_windings(Session& session, const CalibrateOptions& options, PushedSides pushed,
                       const protocol::Description& before, Calibration& found) {
  Windings windings(session, options, std::move(pushed), before);
  const int code = windings.run();
  found = windings.found();
  return code;
}

}  // namespace hedgehog::client
