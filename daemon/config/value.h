// SPDX-License-Identifier: MIT
// A JSON value that knows its line, so that a wrong number can be shown where it was written. The
// JSON library itself stays in json_text.cpp. Start-up and reload only; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hedgehog::config {

struct Value {
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kText, kArray, kObject };

  Kind kind = Kind::kNull;
  bool boolean = false;
  double number = 0.0;
  std::string text;
  /// Elements of an array or values of an object.
  std::vector<Value> elements;
  /// Of an object: names of `elements`, in the order of the file; a name may come twice.
  std::vector<std::string> keys;
  /// From 1; of the key, for a member of an object.
  int line = 0;

  static Value of(bool b);
  static Value of(double n);
  static Value of(std::string s);
  static Value array(std::vector<Value> elements);
  static Value object();

  /// Puts `value` at "a.b.c", making the objects a and b. REQUIRES: this is an object.
  void put(const std::string& path, Value value);
};

/// "12", "\"abc\"", "an object": for "must be …, not …". Long texts are cut.
std::string describe(const Value& value);

}  // namespace hedgehog::config
