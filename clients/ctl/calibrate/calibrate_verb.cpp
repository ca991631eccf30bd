// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/calibrate_verb.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "clients/ctl/calibrate/calibration.h"
#include "clients/ctl/calibrate/felt_sides.h"
#include "clients/ctl/calibrate/winding_bench.h"
#include "clients/ctl/screen/words.h"
#include "model/coils.h"

namespace hedgehog::client {
namespace {

constexpr int kCannotCreate = 73;
constexpr double kFrequencyHz = 47.0;
/// The first look at a winding of which nothing is known, A: too little for the watchdog to take a
/// winding of a third of its resistance, turned or swapped for a fault.
constexpr double kGlanceA = 0.3;
constexpr double kGlanceS = 0.2;
constexpr double kTakeS = 0.6;
/// Below 1.5 A a wrong resistance cannot look like heat.
constexpr double kUnknownA = 1.2;
/// What a person feels well, A; only where the daemon knows the resistance to `kKnown`.
constexpr double kPushA = 3.0;
constexpr double kKnown = 0.03;
/// More than windings of one kind differ.
constexpr double kOdd = 0.25;
/// Windings of a ball at rest are this close to their thermometer.
constexpr double kRestK = 2.0;

/// A trip that a resistance far from the device file's brings about; any other trip, a refusal or a
/// lost daemon says nothing of the winding.
bool blames_resistance(std::string_view reason) {
  return reason == "current_mismatch" || reason == "sensor_frozen" || reason == "sensor_disagrees";
}

int say_wrong(const std::string& what) {
  std::fprintf(stderr, "hedgehogctl calibrate: %s\n", what.c_str());
  return kEndedOtherwise;
}

int give_up(const ClientError& error) {
  if (!interrupted()) return complain(error);
  std::fputs("hedgehogctl calibrate: interrupted; the coils are off, nothing was written\n",
             stderr);
  return kInterrupted;
}

class Calibrator {
 public:
  Calibrator(Session& session, const CalibrateOptions& options, PushedSides pushed,
             const protocol::Description& before)
      : bench_(session), options_(options), before_(before) {
    asks_ = options.pushed.empty() && isatty(STDIN_FILENO) != 0;
    found_.pushed = std::move(pushed);
    found_.name = options.name.empty() ? before.name : options.name;
  }

  int run() {
    if (before_.gain < 1.0) {
      return say_wrong("the gain is " + fixed(before_.gain, 2) +
                       " and would weaken every current; run: hedgehogctl gain 1");
    }
    const auto rest = bench_.rest();
    if (!rest) return give_up(rest.error());
    std::printf(
        "%s: one winding at a time, never more than %s A.\nCtrl-C switches the coils off.\n",
        before_.name.c_str(),
        fixed(asks_ ? std::max(options_.current_a, kPushA) : options_.current_a, 1).c_str());
    found_.sensor_c = *rest->sensor;
    warn_of_heat(*rest);
    for (int coil = 0; coil < 3; ++coil) {
      if (const int code = measure(coil); code != kDone) return code;
    }
    if (const int code = learn_sides(); code != kDone) return code;
    return write();
  }

 private:
  void warn_of_heat(const protocol::TemperatureStatus& rest) const {
    double apart_k = 0.0;
    for (const double winding_c : rest.coils) {
      apart_k = std::max(apart_k, std::abs(winding_c - found_.sensor_c));
    }
    if (apart_k < kRestK) return;
    std::printf(
        "A winding and its thermometer are %s K apart: r25_ohm will be up to %s %% wrong. Let the\n"
        "ball rest for ten minutes and calibrate again.\n",
        fixed(apart_k, 0).c_str(), fixed(100.0 * model::kCopperPerKelvin * apart_k, 1).c_str());
  }

  struct Steady {
    WindingRecord forth, back;
    std::optional<double> resistance_ohm;
  };
  Outcome<Steady> steady(int coil, double current_a, double take_s) {
    auto forth = bench_.hold(coil, 1.0, current_a, take_s);
    if (!forth) return forth.error();
    auto back = bench_.hold(coil, -1.0, current_a, take_s);
    if (!back) return back.error();
    const auto resistance = steady_resistance(forth->samples, back->samples);
    return Steady{*std::move(forth), *std::move(back), resistance};
  }

  static std::string trouble_of(int coil, const Steady& seen) {
    return winding_trouble(coil, seen.forth.mean_a, seen.back.mean_a, seen.resistance_ohm);
  }

  int measure(int coil) {
    const auto i = static_cast<std::size_t>(coil);
    const auto glance = steady(coil, kGlanceA, kGlanceS);
    if (!glance) return give_up_at_first_sight(coil, glance.error());
    if (const auto trouble = trouble_of(coil, *glance); !trouble.empty()) return say_wrong(trouble);
    const double believed_ohm = at_rest(before_.coils.r25_ohm[i]);
    const double ratio = *glance->resistance_ohm / believed_ohm;
    const bool known = std::abs(ratio - 1.0) < kKnown;
    // The daemon thinks in its own resistance, so less of it brings more current.
    const double current_a =
        (known ? options_.current_a : std::min(options_.current_a, kUnknownA)) *
        std::min(1.0, ratio);
    const auto seen = steady(coil, current_a, kTakeS);
    if (!seen) return give_up(seen.error());
    if (const auto trouble = trouble_of(coil, *seen); !trouble.empty()) return say_wrong(trouble);
    const auto sine = bench_.sine(coil, current_a, kFrequencyHz);
    if (!sine) return give_up(sine.error());
    const auto impedance = sine_impedance(sine->samples, kFrequencyHz);
    if (!impedance) {
      return say_wrong("the current of winding " + std::string(1, kAxisNames[coil]) +
                       " does not follow the voltage");
    }
    const double resistance_ohm = *seen->resistance_ohm;
    found_.r25_ohm[i] = resistance_ohm / at_rest(1.0);
    found_.inductance_h[i] = impedance->inductance_h;
    found_.supply_v = seen->forth.supply_v;
    found_.current_a = std::max(found_.current_a, std::abs(seen->forth.mean_a[i]));
    std::printf("  %c  %s ohm at %s °C, %s at 25 °C   %s mH   current as asked\n", kAxisNames[coil],
                fixed(resistance_ohm, 4).c_str(), fixed(found_.sensor_c, 1).c_str(),
                fixed(found_.r25_ohm[i], 4).c_str(),
                fixed(1000.0 * found_.inductance_h[i], 3).c_str());
    if (std::abs(found_.r25_ohm[i] / before_.coils.r25_ohm[i] - 1.0) > kOdd) {
      std::printf("     The file until now says %s: is it wound so, or a bad contact, a short?\n",
                  fixed(before_.coils.r25_ohm[i], 4).c_str());
    }
    std::fflush(stdout);
    return kDone;
  }

  /// A resistance at 25 Celsius, as it is now.
  double at_rest(double r25_ohm) const {
    return r25_ohm * (1.0 + model::kCopperPerKelvin * (found_.sensor_c - 25.0));
  }

  int give_up_at_first_sight(int coil, const ClientError& error) const {
    const int code = give_up(error);
    if (interrupted() || !blames_resistance(bench_.tripped().value_or(""))) return code;
    std::ostringstream text;
    text << "winding " << kAxisNames[coil] << " was driven with " << fixed(kGlanceA, 1)
         << " A. If all plugs are right it has less than a quarter of the "
         << fixed(before_.coils.r25_ohm[static_cast<std::size_t>(coil)], 2)
         << " ohm in the device file: measure it by hand, write it there (r25_ohm), restart "
            "hedgehogd and calibrate again";
    return say_wrong(text.str());
  }

  bool resistance_known(std::size_t winding) const {
    return std::abs(found_.r25_ohm[winding] / before_.coils.r25_ohm[winding] - 1.0) < kKnown;
  }

  int learn_sides() {
    if (!asks_) {
      if (!coil_matrix(found_.pushed)) {
        std::puts("The coil matrix stays as it was: nobody said which side each winding pushes.");
      }
      return kDone;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!resistance_known(i)) {
        std::puts(
            "The coil matrix stays as it was: the resistances in force are too far from these\n"
            "for a push that can be felt. Start hedgehogd with the new file, then calibrate\n"
            "once more: you will be asked which side each winding pushes.");
        return kDone;
      }
    }
    auto felt = ask_sides(bench_, kPushA);
    if (!felt) return give_up(felt.error());
    found_.pushed = *std::move(felt);
    return kDone;
  }

  int write() const {
    std::ofstream file(options_.out, std::ios::trunc);
    file << device_file(found_, before_);
    file.close();
    if (!file) {
      say_wrong(options_.out + ": cannot be written");
      return kCannotCreate;
    }
    const std::string name = std::filesystem::path(options_.out).stem().string();
    std::printf(
        "wrote %s\n"
        "To use it: copy it into /etc/hedgehog/devices.d, write \"device\": \"%s\"\n"
        "into /etc/hedgehog/hedgehogd.json, restart hedgehogd.\n",
        options_.out.c_str(), name.c_str());
    return kDone;
  }

  WindingBench bench_;
  const CalibrateOptions& options_;
  const protocol::Description& before_;
  Calibration found_;
  /// A person is there who can feel, and nobody has said it yet.
  bool asks_ = false;
};

}  // namespace

int run_calibrate(Session& session, const CalibrateOptions& options) {
  const auto pushed = read_pushed(options.pushed);
  if (!pushed) {
    say_wrong("--pushed is like x=front,y=left,z=up, each winding on an axis of its own");
    return kUsage;
  }
  if (!options.force && access(options.out.c_str(), F_OK) == 0) {
    say_wrong(options.out + " is there already; --force replaces it");
    return kCannotCreate;
  }
  if (auto hello = session.connection.hello("hedgehogctl"); !hello) return complain(hello.error());
  const auto before = session.connection.call(protocol::DeviceDescribe{});
  if (!before) return complain(before.error());
  return Calibrator(session, options, *pushed, *before).run();
}

}  // namespace hedgehog::client
