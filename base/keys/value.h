// SPDX-License-Identifier: MIT
// A JSON value with its line, so that an error can be reported at its position. The JSON library is
// confined to json_text.cpp. Start-up and reload only; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::keys {

struct Value {
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kText, kArray, kObject };

  Kind kind = Kind::kNull;
  bool boolean = false;
  double number = 0.0;
  std::string text;
  /// Elements of an array or values of an object.
  std::vector<Value> elements;
  /// Objects: names of `elements`, in the order of the file; may contain duplicates.
  std::vector<std::string> keys;
  /// From 1; for a member of an object, the line of its key.
  int line = 0;

  static Value of(bool b);
  static Value of(double n);
  static Value of(std::string s);
  static Value array(std::vector<Value> elements);
  static Value object();

  /// Sets `value` at "a.b.c", creating the objects a and b. REQUIRES: this is an object.
  void put(const std::string& path, Value value);
};

/// "12", "\"abc\"", "an object": for "must be …, not …". Long texts are truncated.
std::string describe(const Value& value);

/// On one line of a terminal: control characters, C1 too, as "\u001b".
std::string printable(std::string_view text);

}  // namespace hedgehog::keys
