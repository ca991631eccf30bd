// SPDX-License-Identifier: MIT
#include "clients/study/experiment_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/keys/json_text.h"
#include "base/keys/key_tree.h"
#include "clients/common/file_problem.h"

namespace hedgehog::study {

namespace {

using keys::Choices;
using keys::Key;
using keys::Reason;
using keys::Value;

// Limits of the daemon (protocol/README.md).
constexpr double kMaxCurrentA = 15.0;
constexpr double kMaxSpeed = 100.0;
constexpr double kMinSpeed = 0.1;
constexpr double kLongestMs = 10'000;
constexpr double kMany = 1'000'000;

/// What the keys are read into: the unit of the levels depends on another key.
struct Draft {
  Experiment experiment;
  double start = 0.0, floor = 0.0, ceiling = 0.0;
  double step_ratio = 1.0;
  Value stages;
};

Reason read_line(const Value& value, std::string& out) {
  const bool one_line = std::none_of(value.text.begin(), value.text.end(),
                                     [](unsigned char c) { return c < ' ' || c == 0x7F; });
  if (value.kind != Value::Kind::kText || value.text.empty() || !one_line)
    return keys::must_be("a text of one line", value);
  out = value.text;
  return {};
}

Reason read_experiment_name(const Value& value, std::string& out) {
  if (value.text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos)
    return "takes small letters, digits and '-' only: files are called after it";
  return read_line(value, out);
}

std::vector<Key<Draft>> make_keys() {
  using D = Draft;
  constexpr Choices<Task, 2> kTasks{
      {{"yes_no", Task::kYesNo}, {"two_intervals", Task::kTwoIntervals}}};
  constexpr Choices<Quantity, 3> kQuantities{{{"current_a", Quantity::kCurrentA},
                                              {"current_percent", Quantity::kCurrentPercent},
                                              {"speed_percent", Quantity::kSpeedPercent}}};
  constexpr Choices<bool, 2> kSenses{{{"ccw", false}, {"cw", true}}};
  constexpr Choices<IntervalOrder, 2> kOrders{
      {{"random", IntervalOrder::kRandom}, {"balanced", IntervalOrder::kBalanced}}};
  const auto rule = [](auto member) {
    return [member](auto& d) -> auto& { return d.experiment.rule.*member; };
  };
  const auto pattern = [](auto member) {
    return [member](auto& d) -> auto& { return d.experiment.pattern.*member; };
  };
  const auto of = [](auto member) {
    return [member](auto& d) -> auto& { return d.experiment.*member; };
  };
  const auto draft = [](auto member) {
    return [member](auto& d) -> auto& { return d.*member; };
  };
  using E = Experiment;
  using R = StaircaseRule;
  using P = Pattern;
  return {
      {"name", [](D& d, const Value& v) { return read_experiment_name(v, d.experiment.name); },
       [](const D& d) { return Value::of(d.experiment.name); }},
      {"question", [](D& d, const Value& v) { return read_line(v, d.experiment.question); },
       [](const D& d) { return Value::of(d.experiment.question); }},
      keys::choice_key<D>("task", kTasks, of(&E::task)),
      keys::choice_key<D>("level", kQuantities, of(&E::quantity)),
      keys::number_key<D>("start", 0, kMany, draft(&D::start)),
      keys::number_key<D>("floor", 0, kMany, draft(&D::floor)),
      keys::number_key<D>("ceiling", 0, kMany, draft(&D::ceiling)),
      keys::number_key<D>("step_ratio", 0.01, 100, draft(&D::step_ratio)),
      {"stages",
       [](D& d, const Value& v) {
         d.stages = v;
         return Reason();
       },
       [](const D& d) { return d.stages; }},
      keys::integer_key<D>("positives_down", 1, 10, rule(&R::positives_down)),
      keys::integer_key<D>("negatives_up", 1, 10, rule(&R::negatives_up)),
      keys::boolean_key<D>("quick_start", rule(&R::quick_start)),
      keys::integer_key<D>("discard", 0, kMany, rule(&R::discard)),
      keys::integer_key<D>("max_trials", 1, kMany, rule(&R::max_trials)),
      keys::integer_key<D>("duration_ms", 100, kLongestMs, pattern(&P::duration_ms)),
      keys::integer_key<D>("gap_ms", 0, kLongestMs, pattern(&P::gap_ms)),
      keys::number_key<D>("current_a", 0, kMaxCurrentA, pattern(&P::current_a)),
      keys::number_key<D>("speed_pins_s", kMinSpeed, kMaxSpeed, pattern(&P::speed_pins_s)),
      keys::number_key<D>("ring_deg", 1, 179, pattern(&P::ring_deg)),
      keys::choice_key<D>("sense", kSenses, pattern(&P::clockwise)),
      keys::choice_key<D>("order", kOrders, of(&E::order)),
      keys::integer_key<D>("catch_one_in", 0, 1000, of(&E::catch_one_in)),
      keys::integer_key<D>("practice", 0, 100, of(&E::practice)),
      keys::integer_key<D>("response_limit_ms", 0, 600'000, of(&E::response_limit_ms)),
      keys::integer_key<D>("rest_every", 0, kMany, of(&E::rest_every)),
  };
}

const std::vector<Key<Draft>>& experiment_keys() {
  static const std::vector<Key<Draft>> kKeys = make_keys();
  return kKeys;
}

/// The checks that need several keys.
class Checks {
 public:
  Checks(Draft& draft, const keys::Origins& origins, const std::string& file,
         keys::FileErrors& errors)
      : draft_(draft), e_(draft.experiment), origins_(origins), file_(file), errors_(errors) {}

  void run() {
    for (const char* key : {"name", "task", "level", "question", "start", "ceiling", "stages"})
      if (!origins_.contains(key)) wrong(key, "is missing");
    level("start", draft_.start, e_.rule.start);
    level("floor", draft_.floor, e_.rule.floor);
    level("ceiling", draft_.ceiling, e_.rule.ceiling);
    if (origins_.contains("stages")) stages();
    together();
  }

 private:
  void wrong(const std::string& key, std::string reason) {
    errors_.push_back(keys::error_at(origins_, key, std::move(reason), file_));
  }

  void level(const char* key, double value, Level& out) {
    const auto exact = from_value(value, e_.decimals());
    if (!exact) return wrong(key, "has more than " + std::to_string(e_.decimals()) + " decimals");
    out = *exact;
  }

  void stages() {
    const Value& list = draft_.stages;
    if (list.kind != Value::Kind::kArray || list.elements.empty())
      return wrong("stages", "must be a list of at least one stage");
    for (const Value& item : list.elements) {
      const Reason reason = stage(item);
      if (!reason.empty()) errors_.push_back({file_, item.line, "stages", reason});
    }
  }

  Reason stage(const Value& item) {
    const auto number = [&](const char* key) -> std::optional<double> {
      const auto found = std::find(item.keys.begin(), item.keys.end(), key);
      if (found == item.keys.end()) return std::nullopt;
      const Value& value = item.elements[static_cast<std::size_t>(found - item.keys.begin())];
      return value.kind == Value::Kind::kNumber ? std::optional(value.number) : std::nullopt;
    };
    const auto step_up = number("step_up");
    const auto step_down = number("step_down");
    const auto reversals = number("reversals");
    if (!step_up || !reversals || item.keys.size() != (step_down ? 3U : 2U))
      return "a stage has the numbers step_up, reversals and maybe step_down";
    const auto up = from_value(*step_up, e_.decimals());
    const auto down = step_down
                          ? from_value(*step_down, e_.decimals())
                          : std::llround(draft_.step_ratio * static_cast<double>(up.value_or(0)));
    if (!up || *up <= 0 || !down || *down <= 0 || !(*reversals >= 1 && *reversals <= kMany) ||
        *reversals != std::floor(*reversals)) {
      return "steps must be above 0 with at most " + std::to_string(e_.decimals()) +
             " decimals, reversals a whole number of at least 1";
    }
    e_.rule.stages.push_back({*up, *down, static_cast<int>(*reversals)});
    return {};
  }

  void together() {
    const StaircaseRule& rule = e_.rule;
    if (rule.floor > rule.start || rule.start > rule.ceiling)
      wrong("start", "must lie between floor and ceiling");
    if (rule.discard >= rule.total_reversals() && !rule.stages.empty())
      wrong("discard", "leaves no reversal for the mean");
    if ((e_.task == Task::kYesNo) != (e_.quantity == Quantity::kCurrentA))
      wrong("level", "\"yes_no\" goes with \"current_a\", \"two_intervals\" with a percentage");
    if (e_.catch_one_in != 0 && (e_.task != Task::kYesNo || e_.catch_one_in < 3))
      wrong("catch_one_in", "0, or for \"yes_no\" 3 and more (never two in a row)");
    if (e_.task == Task::kTwoIntervals && e_.pattern.current_a <= 0.0)
      wrong("current_a", "must be above 0: the reference of two intervals is felt");
    const Stimulus most = test_stimulus(e_, rule.ceiling);
    if (most.current_a > kMaxCurrentA + 1e-9 || most.speed_pins_s > kMaxSpeed + 1e-9) {
      wrong("ceiling", "is " + describe(Value::of(most.current_a)) + " A at " +
                           describe(Value::of(most.speed_pins_s)) +
                           " pins/s; a ball plays at most 15 A and 100 pins/s");
    }
  }

  Draft& draft_;
  Experiment& e_;
  const keys::Origins& origins_;
  const std::string& file_;
  keys::FileErrors& errors_;
};

}  // namespace

Result<Experiment> parse_experiment(std::string_view text, const std::string& file) {
  const auto root = keys::parse_json(text, file);
  if (root.has_error()) return problem_of(EX_CONFIG, {root.error()});
  Draft draft;
  keys::Origins origins;
  keys::FileErrors errors;
  keys::read_keys(*root, file, experiment_keys(), draft, origins, errors);
  if (root->kind == Value::Kind::kObject) Checks(draft, origins, file, errors).run();
  if (!errors.empty()) return problem_of(EX_CONFIG, errors);
  return std::move(draft.experiment);
}

}  // namespace hedgehog::study
