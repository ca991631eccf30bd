// SPDX-License-Identifier: MIT
#include "base/keys/key.h"

#include <algorithm>
#include <cctype>

namespace hedgehog::keys {
namespace {

std::string range(double min, double max) {
  return describe(Value::of(min)) + " to " + describe(Value::of(max));
}

}  // namespace

Reason must_be(const std::string& what, const Value& got) {
  return "must be " + what + ", not " + describe(got);
}

Reason read_number(const Value& value, double min, double max, double& out) {
  if (value.kind != Value::Kind::kNumber) return must_be("a number, " + range(min, max), value);
  if (!(value.number >= min && value.number <= max)) return must_be(range(min, max), value);
  out = value.number;
  return {};
}

Reason read_integer(const Value& value, double min, double max, double& out) {
  if (value.kind != Value::Kind::kNumber || value.number != std::floor(value.number))
    return must_be("a whole number, " + range(min, max), value);
  return read_number(value, min, max, out);
}

Reason read_boolean(const Value& value, bool& out) {
  if (value.kind != Value::Kind::kBoolean) return must_be("true or false", value);
  out = value.boolean;
  return {};
}

Reason read_name(const Value& value, std::string& out) {
  const auto allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
  };
  if (value.kind != Value::Kind::kText || value.text.empty() || value.text.size() > 32 ||
      !std::all_of(value.text.begin(), value.text.end(), allowed))
    return must_be("a name of 1 to 32 letters, digits, \"-\", \"_\" or \".\"", value);
  out = value.text;
  return {};
}

Reason read_serial(const Value& value, std::string& out) {
  const bool printable = std::all_of(value.text.begin(), value.text.end(),
                                     [](char c) { return c > 0x20 && c < 0x7f; });
  const bool text = value.kind == Value::Kind::kText && printable && !value.text.empty() &&
                    value.text.size() <= 126;
  if (value.kind != Value::Kind::kNull && !text) return must_be("a serial number or null", value);
  out = value.text;
  return {};
}

}  // namespace hedgehog::keys
