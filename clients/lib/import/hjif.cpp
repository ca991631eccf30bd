// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "clients/lib/import/foreign_json.h"
#include "clients/lib/import/import.h"
#include "clients/lib/import/reading.h"
#include "clients/lib/import/timeline.h"

namespace hedgehog::client {

namespace {

/// Ticks: far beyond the end of any pattern.
constexpr double kFar = 1e15;
/// Modalities of pushes or vibrations with a level of their own. The reference encoder writes
/// `Other` for all of them.
constexpr std::array<std::string_view, 4> kFelt{"Vibrotactile", "Force", "Pressure", "Other"};

class Hjif {
 public:
  Outcome<Reading> read(const ForeignJson& file) {
    const auto* perceptions = member(file, "perceptions").as<ForeignJson::List>();
    if (perceptions == nullptr)
      return bad_data("perceptions: an hjif file has a list of that name");
    ms_per_tick_ = 1000.0 / number(file, "timescale", 1000.0, 1e-3, 1e9);
    for (const ForeignJson& perception : *perceptions) take_perception(perception);
    if (effects_ > kMaxImportEvents) {
      return bad_data("the file has more than " + std::to_string(kMaxImportEvents) +
                      " effects and key frames");
    }
    Reading reading;
    reading.description = one_line(text(file, "description"));
    take_wave(reading);
    if (channels_ > 1) note("its channels are played as one");
    reading.layers = std::move(layers_);
    reading.notes = std::move(notes_);
    return reading;
  }

 private:
  void note(std::string sentence) { notes_.add(std::move(sentence)); }

  void take_perception(const ForeignJson& perception) {
    const std::string modality = text(perception, "perception_modality");
    if (std::find(kFelt.begin(), kFelt.end(), modality) == kFelt.end()) {
      note("perceptions of the modality '" + one_line(modality) + "' are left out");
      return;
    }
    if (modality == "Other") note("perceptions of the modality 'Other' are taken for vibrotactile");
    library_.clear();
    for (const ForeignJson& effect : list(perception, "effect_library"))
      library_[number(effect, "id", -1, -1, 1e9)] = &effect;
    for (const ForeignJson& channel : list(perception, "channels")) {
      gain_ = number(channel, "gain", 1.0, -100.0, 100.0);
      const std::size_t before = layers_.size();
      if (is_object(member(channel, "direction")))
        note("a channel's direction is left out: set rotate_to when playing it");
      for (const ForeignJson& band : list(channel, "bands")) take_band(band);
      channels_ += layers_.size() > before ? 1 : 0;
    }
  }

  void take_band(const ForeignJson& band) {
    const std::string type = text(band, "band_type");
    const bool known = type == "Transient" || type == "Curve" || type == "VectorialWave";
    if (!known) {
      note("bands of the type '" + one_line(type) + "' are left out");
      return;
    }
    const std::string curve = text(band, "curve_type");
    if (type == "Curve" && !curve.empty() && curve != "Linear" && curve != "Cubic")
      note("curves of the type '" + one_line(curve) + "' are drawn with straight lines");
    for (const ForeignJson& effect : list(band, "effects")) {
      const ForeignJson* basis = basis_of(effect);
      if (basis == nullptr) continue;
      const double position_ms = ms_per_tick_ * number(effect, "position", 0.0, 0.0, kFar);
      if (type == "Transient")
        take_transients(*basis, position_ms);
      else
        take_effect(type == "VectorialWave", curve == "Cubic", *basis, position_ms);
    }
  }

  /// The effect that contains the key frames; nullptr: there is none.
  const ForeignJson* basis_of(const ForeignJson& effect) {
    const std::string kind = text(effect, "effect_type");
    const ForeignJson* basis = &effect;
    if (kind == "Reference") {
      const auto found = library_.find(number(effect, "id", -1, -1, 1e9));
      if (found == library_.end()) {
        note("references to effects that the library does not have are left out");
        return nullptr;
      }
      basis = found->second;
    }
    const std::string found_kind = text(*basis, "effect_type");
    if (found_kind == "Basis") return basis;
    note("effects of the type '" + one_line(found_kind) + "' are left out");
    return nullptr;
  }

  /// Times of `keys`, ms from the beginning of the file. They are written in order of time; the
  /// reference encoder writes those a little before their effect as unsigned 16-bit numbers.
  std::vector<double> times_of(const ForeignJson::List& keys, double position_ms) {
    constexpr double kWrap = 65'536.0;
    constexpr double kMinNegative = 32'768.0;
    constexpr double kSurelyNegative = kWrap - 256.0;  // unless preceded by one >= kMinNegative
    std::vector<double> written;
    for (const ForeignJson& key : keys)
      written.push_back(number(key, "relative_position", 0.0, -kFar, kFar));
    std::vector<bool> falls(written.size());  // a lower value follows
    double lowest = kFar;
    for (std::size_t i = written.size(); i-- > 0; lowest = std::min(lowest, written[i]))
      falls[i] = lowest < written[i];
    std::vector<double> times_ms;
    bool follows_positive = true;
    for (std::size_t i = 0; i < written.size(); ++i) {
      double ticks = written[i];
      const bool alone = follows_positive && ticks >= kSurelyNegative;
      follows_positive = alone || ticks < kMinNegative;
      if ((falls[i] || alone) && ticks >= kMinNegative && ticks < kWrap) {
        note(
            "a relative_position from 32768 that comes before a lower one, or close to 65536 "
            "without others from 32768 before it, is taken for a negative number of 16 bits");
        ticks -= kWrap;
      }
      times_ms.push_back(std::max(0.0, position_ms + ms_per_tick_ * ticks));
    }
    return times_ms;
  }
  std::optional<double> level_of(const ForeignJson& key) {
    const auto amplitude = number(key, "amplitude_modulation", -1.0, 1.0);
    if (!amplitude) return std::nullopt;
    const double level = gain_ * *amplitude;
    if (level < 0.0) note("negative amplitudes are left out: pins push, they never pull");
    if (level > 1.0) note("a gain that makes levels of more than 1 is cut there");
    return std::clamp(level, 0.0, 1.0);
  }
  static std::optional<double> hz_of(const ForeignJson& key) {
    return number(key, "frequency_modulation", 0.0, 1e6);
  }

  void take_transients(const ForeignJson& effect, double position_ms) {
    const ForeignJson::List& keys = list(effect, "keyframes");
    const std::vector<double> times_ms = times_of(keys, position_ms);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const ForeignJson& key = keys[i];
      if (++effects_ > kMaxImportEvents) return;
      if (hz_of(key)) note("frequencies of transients are left out: each is one push of 25 ms");
      const auto level = level_of(key);
      if (!level) {
        note("transients without an amplitude are left out");
        continue;
      }
      layers_.push_back({{{times_ms[i], *level}, {times_ms[i] + kTransientMs, *level}}});
      pushes_ = true;
    }
  }

  /// A curve or a wave. Each modulation is interpolated over the key frames that contain it. A wave
  /// lasts until its last key frame, a curve until the last with an amplitude; both begin at
  /// `position`.
  void take_effect(bool wave, bool cubic, const ForeignJson& effect, double position_ms) {
    Layer layer;
    std::vector<Layer::Point> pitches;
    double end_ms = position_ms;
    const ForeignJson::List& keys = list(effect, "keyframes");
    const std::vector<double> times_ms = times_of(keys, position_ms);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const ForeignJson& key = keys[i];
      if (++effects_ > kMaxImportEvents) return;
      const double t_ms = times_ms[i];
      end_ms = std::max(end_ms, t_ms);
      if (const auto level = level_of(key)) layer.points.push_back({t_ms, *level, cubic && !wave});
      if (const auto hz = hz_of(key)) pitches.push_back({t_ms, *hz});
    }
    if (layer.points.empty()) {
      if (!wave && end_ms > position_ms) {
        note("curves without an amplitude are left out");
        return;
      }
      layer.points.push_back({position_ms, std::clamp(gain_, 0.0, 1.0)});
    }
    std::stable_sort(layer.points.begin(), layer.points.end(),
                     [](const Layer::Point& a, const Layer::Point& b) { return a.t_ms < b.t_ms; });
    if (layer.points.front().t_ms > position_ms)
      layer.points.insert(layer.points.begin(), {position_ms, layer.points.front().level});
    if (wave && layer.points.back().t_ms < end_ms)
      layer.points.push_back({end_ms, layer.points.back().level});
    if (layer.points.back().t_ms <= position_ms) {
      note("effects that last no time are left out");
      return;
    }
    if (wave)
      count_wave(text(effect, "base_signal"), layer, pitches);
    else
      pushes_ = true;
    layers_.push_back(std::move(layer));
  }

  void count_wave(const std::string& signal, const Layer& layer,
                  const std::vector<Layer::Point>& pitches) {
    if (!waves_) wave_ = signal;
    if (wave_ != signal) note("waves of different signals are played as the first one's");
    waves_ = true;
    for (const Layer::Point& pitch : pitches) {
      const double felt = held(layer.points, pitch.t_ms);
      frequency_sum_ += felt * pitch.level;
      weight_ += felt;
      lowest_hz_ = std::min(lowest_hz_, pitch.level);
      highest_hz_ = std::max(highest_hz_, pitch.level);
    }
  }

  /// One wave for the whole pattern, if it contains only waves.
  void take_wave(Reading& reading) {
    if (!waves_) return;
    if (pushes_) {
      note("waves are played as pushes, because there are transients or curves beside them");
      return;
    }
    if (lowest_hz_ > highest_hz_) {
      note("waves without a frequency are played as pushes");
      return;
    }
    using model::Waveform;
    static const std::map<std::string, Waveform> kSignals{{"Sine", Waveform::kSine},
                                                          {"Square", Waveform::kSquare},
                                                          {"Triangle", Waveform::kTriangle},
                                                          {"SawToothUp", Waveform::kSawtooth}};
    const auto signal = kSignals.find(wave_);
    if (signal == kSignals.end()) note("the signal '" + one_line(wave_) + "' is played as a sine");
    reading.waveform = signal == kSignals.end() ? Waveform::kSine : signal->second;
    constexpr double kMinHz = 0.5;
    constexpr double kMaxHz = 250.0;
    const double mean_hz = weight_ > 0.0 ? frequency_sum_ / weight_ : lowest_hz_;
    reading.frequency_hz = std::round(10.0 * std::clamp(mean_hz, kMinHz, kMaxHz)) / 10.0;
    if (highest_hz_ - lowest_hz_ > 1.0) note("frequencies that change are played as their mean");
    if (mean_hz > kMaxHz || mean_hz < kMinHz) note("the frequency is limited to 0.5..250 Hz");
  }

  double ms_per_tick_ = 1.0;
  double gain_ = 1.0;
  std::map<double, const ForeignJson*> library_;
  std::vector<Layer> layers_;
  std::size_t effects_ = 0;
  int channels_ = 0;
  bool waves_ = false;
  bool pushes_ = false;
  std::string wave_;
  double frequency_sum_ = 0.0;
  double weight_ = 0.0;
  double lowest_hz_ = 1e9;
  double highest_hz_ = 0.0;
  Notes notes_;
};

}  // namespace

Outcome<Reading> read_hjif(const ForeignJson& file) { return Hjif().read(file); }

}  // namespace hedgehog::client
