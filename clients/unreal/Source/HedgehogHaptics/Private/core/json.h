// SPDX-License-Identifier: MIT
// JSON without exceptions, RTTI or the user's locale.
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
  /// Deeper nesting is no message of a daemon.
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

  /// nullopt: this is no JSON, or it is nested too deeply.
  static std::optional<Json> parse(std::string_view text);
  /// One line. Numbers that JSON has not (infinite, NaN) become null.
  std::string to_text() const;

  Kind kind() const { return kind_; }
  bool is(Kind kind) const { return kind_ == kind; }
  bool truth() const { return truth_; }
  double number() const { return number_; }
  const std::string& text() const { return text_; }
  const std::vector<Json>& items() const { return items_; }
  const std::vector<Field>& fields() const { return fields_; }
  /// The value of a field; null where there is none.
  const Json& operator[](std::string_view name) const;
  /// Adds the field, or replaces it.
  void set(std::string_view name, Json value);
  /// The same without the fields of an object that are null.
  Json without_nulls() const;
  /// Where a number is that JSON has not: "keyframes[0].level"; empty: nowhere.
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
