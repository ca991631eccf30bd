// SPDX-License-Identifier: MIT
#include "daemon/config/keys/limit_keys.h"

#include <algorithm>
#include <cstddef>

namespace hedgehog::config {

using namespace keys;

namespace {

std::string key_of(const LimitField& field) { return "limits." + std::string(field.name); }
std::string text_of(double number) { return describe(Value::of(number)); }

constexpr std::size_t index_of(double model::Limits::*member) {
  std::size_t i = 0;
  while (kLimitFields.at(i).member != member) ++i;
  return i;
}

const LimitField& field_of(double model::Limits::*member) { return kLimitFields[index_of(member)]; }

}  // namespace

model::Limits tightened(const model::Limits& ceiling, const LimitOverrides& overrides,
                        const Origins& origins, FileErrors& errors) {
  model::Limits limits = ceiling;
  for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
    if (!overrides[i]) continue;
    const LimitField& field = kLimitFields[i];
    if (!field.perception && *overrides[i] > ceiling.*field.member) {
      errors.push_back(error_at(origins, key_of(field),
                                "must be at most " + text_of(ceiling.*field.member) +
                                    ", the limit in the device file, not " +
                                    text_of(*overrides[i]) + ": configuration only tightens",
                                "limits"));
      continue;
    }
    limits.*field.member = *overrides[i];
  }
  // A lower current_a also lowers the default of continuous_a and felt_a.
  for (double model::Limits::*lower : {&model::Limits::continuous_a, &model::Limits::felt_a})
    if (!overrides[index_of(lower)]) limits.*lower = std::min(limits.*lower, limits.current_a);
  return limits;
}

void check_order(const model::Limits& limits, const Origins& origins, const std::string& file,
                 FileErrors& errors) {
  using model::Limits;
  struct Pair {
    double Limits::*lower;
    double Limits::*upper;
    bool may_be_equal;
  };
  static constexpr std::array<Pair, 6> kPairs{{
      {&Limits::continuous_a, &Limits::current_a, true},
      {&Limits::felt_a, &Limits::current_a, true},
      {&Limits::rearm_c, &Limits::derate_from_c, false},
      {&Limits::derate_from_c, &Limits::sustain_c, false},
      {&Limits::sustain_c, &Limits::zero_c, false},
      {&Limits::zero_c, &Limits::trip_c, false},
  }};
  for (const auto& [lower, upper, may_be_equal] : kPairs) {
    const double a = limits.*lower;
    const double b = limits.*upper;
    if (a < b || (may_be_equal && a == b)) continue;
    const LimitField& low = field_of(lower);
    const LimitField& high = field_of(upper);
    // Reports the key that is set; if both are, the lower limit.
    const bool report_high = !origins.contains(key_of(low)) && origins.contains(key_of(high));
    const LimitField& reported = report_high ? high : low;
    const LimitField& other = report_high ? low : high;
    const std::string relation = may_be_equal ? (report_high ? "at least " : "at most ")
                                              : (report_high ? "above " : "below ");
    errors.push_back(error_at(origins, key_of(reported),
                              "must be " + relation + key_of(other) + " (" +
                                  text_of(limits.*other.member) + "), not " +
                                  text_of(limits.*reported.member),
                              file));
  }
}

}  // namespace hedgehog::config
