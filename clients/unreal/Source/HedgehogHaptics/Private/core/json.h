// SPDX-License-Identifier: MIT
// JSON without exceptions, RTTI or dependence on the user's locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hedgehog::unreal {

/// A value. Numbers are doubles: exact for integers up to 2^53.
class Json {
 public:
  using Field = std::pair<std::string, Json>;
  enum class Kind : std::uint8_t { kNull, kBool, kNumber, kString, kArray, kObject };
  /// Limit of nesting, above that of the daemon's messages.
  static constexpr int kMaxDepth = 64;

  Json() = default;
  Json(bool value) : kind_(Kind::kBool), truth_(value) {}
  Json(double value) : kind_(Kind::kNumber), number_(value) {}
  Json(int value) : Json(static_cast<double>(value)) {}
  Json(std::int64_t value) : Json(static_cast<double>(value)) {}
  Json(std::string value) : kind_(Kind::kString), text_(std::move(value)) {}
  Json(const char* value) : Json(std::string(value)) {}
  static Json array(std::vector<Json> items = {});
  static Json object(std::vector<Field> fields = {});

  /// nullopt: invalid JSON, or nested too deeply.
  static std::optional<Json> parse(std::string_view text);
  /// One line. Numbers that JSON cannot represent (infinite, NaN) become null.
  std::string to_text() const;

  Kind kind() const { return kind_; }
  bool is(Kind kind) const { return kind_ == kind; }
  bool truth() const { return truth_; }
  double number() const { return number_; }
  const std::string& text() const { return text_; }
  const std::vector<Json>& items() const { return items_; }
  const std::vector<Field>& fields() const { return fields_; }
  /// The value of a field; null if there is none.
  const Json& operator[](std::string_view name) const;
  /// Adds or replaces the field.
  void set(std::string_view name, Json value);
  /// A copy without the null fields of the object.
  Json without_nulls() const;
  /// Path of a number that JSON cannot represent: "keyframes[0].level"; empty: none.
  std::string non_finite(const std::string& where = {}) const;

  friend bool operator==(const Json& a, const Json& b);
  friend bool operator!=(const Json& a, const Json& b) { return !(a == b); }

 private:
  void append_to(std::string& out) const;

  Kind kind_ = Kind::kNull;
  bool truth_ = false;
  double number_ = 0.0;
  std::string text_;
  std::vector<Json> items_;
  std::vector<Field> fields_;
};

}  // namespace hedgehog::unreal
