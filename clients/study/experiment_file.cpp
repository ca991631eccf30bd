// SPDX-License-Identifier: MIT
#include "clients/study/experiment_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/parse_json.h"
#include "clients/study/json_lines.h"

namespace hedgehog::study {

namespace {

using nlohmann::json;

// Limits of the daemon (protocol/README.md).
constexpr double kMaxCurrentA = 15.0;
constexpr double kMaxSpeed = 100.0;
constexpr double kMinSpeed = 0.1;
constexpr double kLongestMs = 10'000;
constexpr double kMany = 1'000'000;

struct Word {
  std::string_view text;
  int value;
};

/// Reads keys of an object, collects all errors, and records the keys that were read.
class Reader {
 public:
  Reader(const json& object, std::string_view text, const std::string& file)
      : object_(object), text_(text), file_(file) {}

  void number(const char* key, double low, double high, double& value) {
    const json* found = find(key);
    if (found == nullptr) return;
    if (!found->is_number() || !(found->get<double>() >= low && found->get<double>() <= high)) {
      wrong(key, "must be a number from " + plain(low) + " to " + plain(high) + ", not " +
                     found->dump());
      return;
    }
    value = found->get<double>();
  }

  template <class Integer>
  void integer(const char* key, double low, double high, Integer& value) {
    double read = static_cast<double>(value);
    number(key, low, high, read);
    if (read != std::floor(read)) wrong(key, "must be a whole number, not " + plain(read));
    value = static_cast<Integer>(read);
  }

  void level(const char* key, int decimals, double low, double high, Level& value) {
    double read = to_value(value, decimals);
    number(key, low, high, read);
    if (const auto exact = from_value(read, decimals))
      value = *exact;
    else
      wrong(key, "has more than " + std::to_string(decimals) + " decimals");
  }

  void boolean(const char* key, bool& value) {
    if (const json* found = find(key)) {
      if (!found->is_boolean()) {
        wrong(key, "must be true or false, not " + found->dump());
        return;
      }
      value = found->get<bool>();
    }
  }

  void text(const char* key, std::string& value) {
    if (const json* found = find(key)) {
      if (!found->is_string() || found->get<std::string>().empty() ||
          std::any_of(found->get_ref<const std::string&>().begin(),
                      found->get_ref<const std::string&>().end(),
                      [](unsigned char c) { return c < ' ' || c == 0x7F; })) {
        wrong(key, "must be a text of one line, not " + found->dump());
        return;
      }
      value = found->get<std::string>();
    }
  }

  int word(const char* key, int value, std::initializer_list<Word> words) {
    const json* found = find(key);
    if (found == nullptr) return value;
    std::string choice;
    for (const Word& candidate : words) {
      if (found->is_string() && found->get<std::string>() == candidate.text) return candidate.value;
      choice += (choice.empty() ? "\"" : ", \"") + std::string(candidate.text) + "\"";
    }
    wrong(key, "must be one of " + choice + ", not " + found->dump());
    return value;
  }

  const json* find(const char* key) {
    asked_.insert(key);
    const auto at = object_.find(key);
    return at == object_.end() ? nullptr : &*at;
  }
  void require(const char* key) {
    if (find(key) == nullptr) wrong(key, "is missing");
  }
  void refuse_unknown() {
    for (const auto& [key, value] : object_.items())
      if (!asked_.contains(key)) wrong(key, "unknown key");
  }

  void wrong(const std::string& key, const std::string& reason) {
    problems_ += (problems_.empty() ? "" : "\n") + file_ + ":" +
                 std::to_string(line_of_key(text_, key)) + ": " + key + ": " + reason;
  }
  const std::string& problems() const noexcept { return problems_; }

  static std::string plain(double number) { return json(number).dump(); }

 private:
  const json& object_;
  std::string_view text_;
  const std::string& file_;
  std::set<std::string> asked_{};
  std::string problems_{};
};

void read_stages(Reader& reader, const json& stages, double ratio, int decimals,
                 std::vector<Stage>& out) {
  if (!stages.is_array() || stages.empty()) {
    reader.wrong("stages", "must be a list of at least one stage");
    return;
  }
  for (const json& item : stages) {
    const bool own_down = item.is_object() && item.contains("step_down");
    if (!item.is_object() || !item.contains("step_up") || !item["step_up"].is_number() ||
        (own_down && !item["step_down"].is_number()) || !item.contains("reversals") ||
        !item["reversals"].is_number_integer() || item.size() != (own_down ? 3U : 2U)) {
      reader.wrong("stages",
                   "a stage has step_up, reversals and maybe step_down, not " + item.dump());
      return;
    }
    const auto up = from_value(item["step_up"].get<double>(), decimals);
    const auto down = own_down ? from_value(item["step_down"].get<double>(), decimals)
                               : std::llround(ratio * static_cast<double>(up.value_or(0)));
    const auto reversals = item["reversals"].get<std::int64_t>();
    if (!up || *up <= 0 || !down || *down <= 0 || reversals < 1 ||
        reversals > static_cast<std::int64_t>(kMany)) {
      reader.wrong("stages", "steps must be above 0 with at most " + std::to_string(decimals) +
                                 " decimals, reversals at least 1, not " + item.dump());
      return;
    }
    out.push_back({*up, *down, static_cast<int>(reversals)});
  }
}

/// Checks that require all keys.
void check_together(Reader& reader, const Experiment& e) {
  const StaircaseRule& rule = e.rule;
  if (rule.floor > rule.start || rule.start > rule.ceiling)
    reader.wrong("start", "must lie between floor and ceiling");
  if (rule.discard >= rule.total_reversals() && !rule.stages.empty())
    reader.wrong("discard", "leaves no reversal for the mean");
  if ((e.task == Task::kYesNo) != (e.quantity == Quantity::kCurrentA)) {
    reader.wrong("level",
                 "\"yes_no\" goes with \"current_a\", \"two_intervals\" with a percentage");
  }
  if (e.catch_one_in != 0 && (e.task != Task::kYesNo || e.catch_one_in < 3))
    reader.wrong("catch_one_in", "0, or for \"yes_no\" 3 and more (never two in a row)");
  if (e.task == Task::kTwoIntervals && e.pattern.current_a <= 0.0)
    reader.wrong("current_a", "must be above 0: the reference of two intervals is felt");
  const Stimulus most = test_stimulus(e, rule.ceiling);
  if (most.current_a > kMaxCurrentA + 1e-9 || most.speed_pins_s > kMaxSpeed + 1e-9) {
    reader.wrong("ceiling", "is " + Reader::plain(most.current_a) + " A at " +
                                Reader::plain(most.speed_pins_s) +
                                " pins/s; a ball plays at most 15 A and 100 pins/s");
  }
}

Experiment read_experiment(Reader& r) {
  Experiment e;
  for (const char* key : {"name", "task", "level", "question", "start", "ceiling", "stages"})
    r.require(key);
  r.text("name", e.name);
  if (e.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos)
    r.wrong("name", "takes small letters, digits and '-' only: files are called after it");
  r.text("question", e.question);
  e.task = static_cast<Task>(r.word("task", 0,
                                    {{"yes_no", static_cast<int>(Task::kYesNo)},
                                     {"two_intervals", static_cast<int>(Task::kTwoIntervals)}}));
  e.quantity = static_cast<Quantity>(
      r.word("level", 0,
             {{"current_a", static_cast<int>(Quantity::kCurrentA)},
              {"current_percent", static_cast<int>(Quantity::kCurrentPercent)},
              {"speed_percent", static_cast<int>(Quantity::kSpeedPercent)}}));
  const int decimals = e.decimals();
  r.level("start", decimals, 0, kMany, e.rule.start);
  r.level("floor", decimals, 0, kMany, e.rule.floor);
  r.level("ceiling", decimals, 0, kMany, e.rule.ceiling);
  double ratio = 1.0;
  r.number("step_ratio", 0.01, 100, ratio);
  if (const json* stages = r.find("stages"))
    read_stages(r, *stages, ratio, decimals, e.rule.stages);
  r.integer("positives_down", 1, 10, e.rule.positives_down);
  r.integer("negatives_up", 1, 10, e.rule.negatives_up);
  r.boolean("quick_start", e.rule.quick_start);
  r.integer("discard", 0, kMany, e.rule.discard);
  r.integer("max_trials", 1, kMany, e.rule.max_trials);
  r.integer("duration_ms", 100, kLongestMs, e.pattern.duration_ms);
  r.integer("gap_ms", 0, kLongestMs, e.pattern.gap_ms);
  r.number("current_a", 0, kMaxCurrentA, e.pattern.current_a);
  r.number("speed_pins_s", kMinSpeed, kMaxSpeed, e.pattern.speed_pins_s);
  r.number("ring_deg", 1, 179, e.pattern.ring_deg);
  e.pattern.clockwise = r.word("sense", 0, {{"ccw", 0}, {"cw", 1}}) == 1;
  e.order = static_cast<IntervalOrder>(
      r.word("order", 0,
             {{"random", static_cast<int>(IntervalOrder::kRandom)},
              {"balanced", static_cast<int>(IntervalOrder::kBalanced)}}));
  r.integer("catch_one_in", 0, 1000, e.catch_one_in);
  r.integer("practice", 0, 100, e.practice);
  r.integer("response_limit_ms", 0, 600'000, e.response_limit_ms);
  r.integer("rest_every", 0, kMany, e.rest_every);
  r.refuse_unknown();
  check_together(r, e);
  return e;
}

}  // namespace

Result<Experiment> parse_experiment(std::string_view text, const std::string& file) {
  const auto parsed = base::parse_json<json>(text, base::JsonComments::kAllowed);
  if (!parsed.good()) {
    return Problem{EX_CONFIG, file + ":" + std::to_string(line_of_byte(text, parsed.at)) +
                                  ": this is no JSON: " + parsed.problem};
  }
  const json& object = parsed.value;
  if (!object.is_object())
    return Problem{EX_CONFIG, file + ":1: an experiment is an object in braces"};
  Reader reader(object, text, file);
  Experiment experiment = read_experiment(reader);
  if (!reader.problems().empty()) return Problem{EX_CONFIG, reader.problems()};
  return experiment;
}

}  // namespace hedgehog::study
