// SPDX-License-Identifier: MIT
// One key of a configuration file: name, reader with checks, and writer. A file format is a list of
// keys; reading, printing, typo hints and the completeness tests use that list.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/keys/value.h"

namespace hedgehog::keys {

/// Why a value is rejected ("must be …"); empty: accepted.
using Reason = std::string;

template <class Target>
struct Key {
  /// "limits.current_a".
  std::string path;
  std::function<Reason(Target&, const Value&)> read;
  std::function<Value(const Target&)> write;
};

Reason must_be(const std::string& what, const Value& got);
Reason read_number(const Value& value, double min, double max, double& out);
Reason read_integer(const Value& value, double min, double max, double& out);
Reason read_boolean(const Value& value, bool& out);
/// 1..32 of letters, digits, "-", "_", ".".
Reason read_name(const Value& value, std::string& out);
Reason read_serial(const Value& value, std::string& out);

/// In the functions below `get` returns a reference to the value in a (const) Target.
template <class Target, class Get>
Key<Target> number_key(std::string path, double min, double max, Get get) {
  return {std::move(path),
          [=](Target& t, const Value& v) { return read_number(v, min, max, get(t)); },
          [=](const Target& t) { return Value::of(get(t)); }};
}

/// `null` is nullopt.
template <class Target, class Get>
Key<Target> optional_number_key(std::string path, double min, double max, Get get) {
  return {std::move(path),
          [=](Target& t, const Value& v) -> Reason {
            double number = 0.0;
            if (v.kind == Value::Kind::kNull) {
              get(t) = std::nullopt;
              return {};
            }
            Reason reason = read_number(v, min, max, number);
            if (reason.empty()) get(t) = number;
            return reason;
          },
          [=](const Target& t) { return get(t) ? Value::of(*get(t)) : Value{}; }};
}

template <class Target, class Get>
Key<Target> integer_key(std::string path, double min, double max, Get get) {
  return {std::move(path),
          [=](Target& t, const Value& v) {
            double number = 0.0;
            Reason reason = read_integer(v, min, max, number);
            using Integer = std::decay_t<decltype(get(t))>;
            if (reason.empty()) get(t) = static_cast<Integer>(number);
            return reason;
          },
          [=](const Target& t) { return Value::of(static_cast<double>(get(t))); }};
}

template <class Target, class Get>
Key<Target> boolean_key(std::string path, Get get) {
  return {std::move(path), [=](Target& t, const Value& v) { return read_boolean(v, get(t)); },
          [=](const Target& t) { return Value::of(bool{get(t)}); }};
}

template <class Target, class Get>
Key<Target> name_key(std::string path, Get get) {
  return {std::move(path), [=](Target& t, const Value& v) { return read_name(v, get(t)); },
          [=](const Target& t) { return Value::of(std::string(get(t))); }};
}

/// A serial number; `null` (any) is "".
template <class Target, class Get>
Key<Target> serial_key(std::string path, Get get) {
  return {
      std::move(path), [=](Target& t, const Value& v) { return read_serial(v, get(t)); },
      [=](const Target& t) { return get(t).empty() ? Value{} : Value::of(std::string(get(t))); }};
}

/// Names in the file and their values.
template <class Meaning, std::size_t n>
using Choices = std::array<std::pair<std::string_view, Meaning>, n>;

/// `choices`: Choices, or a vector of the same.
template <class Target, class List, class Get>
Key<Target> choice_key(std::string path, List choices, Get get) {
  return {std::move(path),
          [=](Target& t, const Value& v) -> Reason {
            std::string allowed;
            for (std::size_t i = 0; i < choices.size(); ++i) {
              if (v.kind == Value::Kind::kText && v.text == choices[i].first) {
                get(t) = choices[i].second;
                return {};
              }
              if (i > 0) allowed += i + 1 == choices.size() ? " or " : ", ";
              allowed += '"' + std::string(choices[i].first) + '"';
            }
            return must_be(allowed, v);
          },
          [=](const Target& t) {
            for (const auto& [name, value] : choices)
              if (value == get(t)) return Value::of(std::string(name));
            return Value{};
          }};
}

}  // namespace hedgehog::keys
