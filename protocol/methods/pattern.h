// SPDX-License-Identifier: MIT
// pattern.*
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/methods/done.h"
#include "protocol/values/pattern.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct PatternSummary {
  static constexpr std::string_view kSchema = "PatternSummary";
  std::string name{};
  std::string description{};
  std::int64_t duration_ms = 0;  // at rate 1
  std::int64_t keyframes = 0;    // number of key frames
  bool shipped = false;          // read-only

  void describe(Fields& f) {
    f.required("name", name);
    f.required("description", description);
    f.required("duration_ms", duration_ms);
    f.required("keyframes", keyframes);
    f.required("shipped", shipped);
  }
  friend bool operator==(const PatternSummary&, const PatternSummary&) = default;
};

struct PatternsResult {
  static constexpr std::string_view kSchema = "Patterns";
  std::vector<PatternSummary> patterns{};  // sorted by name

  void describe(Fields& f) { f.required("patterns", patterns); }
  friend bool operator==(const PatternsResult&, const PatternsResult&) = default;
};

struct PatternList {
  static constexpr MethodInfo kMethod{"pattern.list", Role::kObserve, "Lists the named patterns."};
  using Result = PatternsResult;
  friend bool operator==(const PatternList&, const PatternList&) = default;
};

/// The fields of the pattern, and those of pattern.list.
struct PatternResult {
  static constexpr std::string_view kSchema = "Pattern";
  Pattern pattern{};
  std::int64_t duration_ms = 0;
  bool shipped = false;

  void describe(Fields& f) {
    pattern.describe(f);
    f.required("duration_ms", duration_ms);
    f.required("shipped", shipped);
  }
  friend bool operator==(const PatternResult&, const PatternResult&) = default;
};

struct PatternGet {
  static constexpr MethodInfo kMethod{"pattern.get",
                                      Role::kObserve,
                                      "One named pattern with its key frames.",
                                      {ErrorCode::kNoSuchPattern}};
  using Result = PatternResult;

  std::string name{};

  void describe(Fields& f) { f.required("name", name, kPatternName); }
  friend bool operator==(const PatternGet&, const PatternGet&) = default;
};

/// Replaces a pattern of the same name.
struct PatternPut {
  static constexpr MethodInfo kMethod{"pattern.put",
                                      Role::kPlay,
                                      "Stores a pattern under vendor/name.",
                                      {ErrorCode::kInternalError}};
  using Result = PatternSummary;

  Pattern pattern{};  // its fields are the parameters

  void describe(Fields& f) { pattern.describe(f); }
  friend bool operator==(const PatternPut&, const PatternPut&) = default;
};

struct PatternRemove {
  static constexpr MethodInfo kMethod{"pattern.remove",
                                      Role::kPlay,
                                      "Removes a stored pattern.",
                                      {ErrorCode::kNoSuchPattern, ErrorCode::kInternalError}};
  using Result = Done;

  std::string name{};

  void describe(Fields& f) { f.required("name", name, kPatternName); }
  friend bool operator==(const PatternRemove&, const PatternRemove&) = default;
};

using PatternMethods = TypeList<PatternList, PatternGet, PatternPut, PatternRemove>;

}  // namespace hedgehog::protocol
