// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "clients/lib/import/foreign_json.h"
#include "clients/lib/import/import.h"
#include "clients/lib/import/reading.h"
#include "clients/lib/import/timeline.h"

namespace hedgehog::client {

namespace {

/// Far beyond the end of any pattern.
constexpr double kFarS = 1e6;

/// One curve, or a dynamic parameter as a curve of one point. Times in ms from the beginning.
struct Control {
  double start_ms = 0.0;
  std::vector<Layer::Point> points;
};

/// Multiplies all intensities: each curve from its beginning until the next begins.
class IntensityControl {
 public:
  void add(Control control) { controls_.push_back(std::move(control)); }
  void finish() {
    std::stable_sort(
        controls_.begin(), controls_.end(),
        [](const Control& a, const Control& b) { return a.start_ms < b.start_ms; });
  }
  double before(double t_ms) const noexcept {
    const auto next = std::lower_bound(controls_.begin(), controls_.end(), t_ms,
                                       [](const Control& c, double t) { return c.start_ms < t; });
    return next == controls_.begin() ? 1.0 : held((next - 1)->points, t_ms);
  }
  double after(double t_ms) const noexcept {
    const auto next = std::upper_bound(controls_.begin(), controls_.end(), t_ms,
                                       [](double t, const Control& c) { return t < c.start_ms; });
    return next == controls_.begin() ? 1.0 : held((next - 1)->points, t_ms);
  }
  std::set<double> times() const {
    std::set<double> all;
    for (const Control& c : controls_) {
      all.insert(c.start_ms);
      for (const Layer::Point& p : c.points) all.insert(p.t_ms);
    }
    return all;
  }

 private:
  std::vector<Control> controls_;
};

class Ahap {
 public:
  Outcome<Reading> read(const ForeignJson& file) {
    const auto* entries = member(file, "Pattern").as<ForeignJson::List>();
    if (entries == nullptr) return bad_data("Pattern: an AHAP file has a list of that name");
    if (entries->size() > kMaxImportEvents) {
      return bad_data("Pattern: has " + std::to_string(entries->size()) + " entries, more than " +
                      std::to_string(kMaxImportEvents));
    }
    for (const ForeignJson& entry : *entries) take(entry);
    control_.finish();
    constexpr std::size_t kMaxWork = 200'000;
    if (events_.size() * (points_ + 1) > kMaxWork)
      return bad_data("Pattern: too many events under too many points of curves");
    if (points_ >= kMaxImportPoints) note("points of curves beyond 4000 are left out");
    return Reading{.description = one_line(text(member(file, "Metadata"), "Description")),
                   .layers = controlled(),
                   .waveform = {},
                   .frequency_hz = {},
                   .notes = std::move(notes_)};
  }

 private:
  using Values = std::map<std::string, double>;

  void note(std::string sentence) { notes_.add(std::move(sentence)); }

  static Values values_of(const ForeignJson& event) {
    Values values;
    for (const ForeignJson& one : list(event, "EventParameters"))
      values[text(one, "ParameterID")] = number(one, "ParameterValue", 0.0, -1e6, 1e6);
    return values;
  }
  static double value(const Values& values, const char* name, double fallback, double low,
                      double high) {
    const auto found = values.find(name);
    return found == values.end() ? fallback : std::clamp(found->second, low, high);
  }

  void take(const ForeignJson& entry) {
    if (const ForeignJson& event = member(entry, "Event"); is_object(event))
      take_event(event);
    else if (const ForeignJson& curve = member(entry, "ParameterCurve"); is_object(curve))
      take_curve(curve);
    else if (const ForeignJson& parameter = member(entry, "Parameter"); is_object(parameter))
      take_parameter(parameter);
  }

  void take_event(const ForeignJson& event) {
    const std::string type = text(event, "EventType");
    const double start_ms = 1000.0 * number(event, "Time", 0.0, 0.0, kFarS);
    const Values values = values_of(event);
    const double level = value(values, "HapticIntensity", 1.0, 0.0, 1.0);
    if (values.contains("HapticSharpness"))
      note("HapticSharpness is left out: a push has no pitch; set frequency_hz when playing it");
    if (type == "HapticTransient")
      events_.push_back({{{start_ms, level}, {start_ms + kTransientMs, level}}});
    else if (type == "HapticContinuous")
      take_continuous(event, values, start_ms, level);
    else if (type.starts_with("Audio"))
      note("audio events are left out");
    else
      note("events of the type '" + one_line(type) + "' are left out");
  }

  void take_continuous(const ForeignJson& event, const Values& values, double start_ms,
                       double level) {
    const double length_ms = 1000.0 * number(event, "EventDuration", 0.0, 0.0, kFarS);
    if (length_ms <= 0.0) {
      note("continuous events without an EventDuration are left out");
      return;
    }
    const double attack_ms = 1000.0 * value(values, "AttackTime", 0, 0, 1);
    const double release_ms = 1000.0 * value(values, "ReleaseTime", 0, 0, 1);
    const double full_ms = std::min(attack_ms, length_ms);
    const double left_ms = length_ms - full_ms;
    const double end_ms = start_ms + length_ms;
    const double peak = attack_ms > length_ms ? level * length_ms / attack_ms : level;
    Layer layer;
    if (attack_ms > 0.0) layer.points.push_back({start_ms, 0.0});
    layer.points.push_back({start_ms + full_ms, peak});
    double last = peak;
    if (value(values, "Sustained", 1, 0, 1) <= 0.5 && left_ms > 0.0) {
      const double given_ms = 1000.0 * value(values, "DecayTime", 0, 0, 1);
      const double decay_ms = given_ms > 0.0 ? given_ms : left_ms;
      last = decay_ms > left_ms ? peak * (1.0 - left_ms / decay_ms) : 0.0;
      layer.points.push_back({start_ms + full_ms + std::min(decay_ms, left_ms), last});
    } else {
      layer.points.push_back({end_ms, last});
    }
    if (release_ms > 0.0 && last > 0.0) layer.points.push_back({end_ms + release_ms, 0.0});
    events_.push_back(std::move(layer));
  }

  bool is_intensity(const ForeignJson& control) {
    const std::string name = text(control, "ParameterID");
    if (name == "HapticIntensityControl") return true;
    note(name == "HapticSharpnessControl"
             ? "HapticSharpnessControl is left out: a push has no pitch"
             : "the parameter '" + one_line(name) + "' is left out");
    return false;
  }

  void take_curve(const ForeignJson& curve) {
    if (!is_intensity(curve)) return;
    Control control;
    control.start_ms = 1000.0 * number(curve, "Time", 0.0, 0.0, kFarS);
    for (const ForeignJson& point : list(curve, "ParameterCurveControlPoints")) {
      if (points_ >= kMaxImportPoints) break;
      ++points_;
      control.points.push_back({control.start_ms + 1000.0 * number(point, "Time", 0.0, 0.0, kFarS),
                                number(point, "ParameterValue", 1.0, 0.0, 1.0)});
    }
    if (control.points.empty()) return;
    std::stable_sort(control.points.begin(), control.points.end(),
                     [](const Layer::Point& a, const Layer::Point& b) { return a.t_ms < b.t_ms; });
    control_.add(std::move(control));
  }

  void take_parameter(const ForeignJson& parameter) {
    if (!is_intensity(parameter)) return;
    const double start_ms = 1000.0 * number(parameter, "Time", 0.0, 0.0, kFarS);
    control_.add({start_ms, {{start_ms, number(parameter, "ParameterValue", 1.0, 0.0, 1.0)}}});
  }

  /// Each event multiplied by the control. Between two points both are linear, so their product is
  /// a parabola, approximated by line segments.
  std::vector<Layer> controlled() const {
    const std::set<double> times = control_.times();
    std::vector<Layer> layers;
    for (const Layer& event : events_) {
      const double first_ms = event.points.front().t_ms;
      const double last_ms = event.points.back().t_ms;
      std::set<double> all(times.lower_bound(first_ms), times.upper_bound(last_ms));
      for (const Layer::Point& point : event.points) all.insert(point.t_ms);
      Layer layer;
      std::optional<double> from_ms;
      for (const double t_ms : all) {
        if (from_ms) {
          const double end = event.before(t_ms) * control_.before(t_ms);
          bend(event, *from_ms, t_ms, end, layer);
          layer.points.push_back({t_ms, end});
        }
        if (t_ms < last_ms)
          layer.points.push_back({t_ms, event.after(t_ms) * control_.after(t_ms)});
        from_ms = t_ms;
      }
      layers.push_back(std::move(layer));
    }
    return layers;
  }

  /// The inner points of the parabola from the last point of `layer` to `end` at `to_ms`.
  void bend(const Layer& event, double from_ms, double to_ms, double end, Layer& layer) const {
    constexpr double kBent = 0.002;
    const auto at = [&](double t_ms) { return event.after(t_ms) * control_.after(t_ms); };
    double off = std::abs(at(0.5 * (from_ms + to_ms)) - 0.5 * (layer.points.back().level + end));
    int pieces = 1;
    for (; off > kBent; off /= 4.0) pieces *= 2;  // half the length, a quarter of the deviation
    for (int piece = 1; piece < pieces; ++piece) {
      const double t_ms = from_ms + (to_ms - from_ms) * piece / pieces;
      layer.points.push_back({t_ms, at(t_ms)});
    }
  }

  std::vector<Layer> events_;
  IntensityControl control_;
  std::size_t points_ = 0;
  Notes notes_;
};

}  // namespace

Outcome<Reading> read_ahap(const ForeignJson& file) { return Ahap().read(file); }

}  // namespace hedgehog::client
