// SPDX-License-Identifier: MIT
#include "base/keys/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.h"

namespace hedgehog::keys {

Value Value::of(bool b) {
  Value value;
  value.kind = Kind::kBoolean;
  value.boolean = b;
  return value;
}

Value Value::of(double n) {
  Value value;
  value.kind = Kind::kNumber;
  value.number = n;
  return value;
}

Value Value::of(std::string s) {
  Value value;
  value.kind = Kind::kText;
  value.text = std::move(s);
  return value;
}

Value Value::array(std::vector<Value> elements) {
  Value value;
  value.kind = Kind::kArray;
  value.elements = std::move(elements);
  return value;
}

Value Value::object() {
  Value value;
  value.kind = Kind::kObject;
  return value;
}

void Value::put(const std::string& path, Value value) {
  const std::size_t dot = path.find('.');
  const std::string key = path.substr(0, dot);
  auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end()) {
    keys.push_back(key);
    elements.push_back(object());
    found = keys.end() - 1;
  }
  Value& place = elements[static_cast<std::size_t>(found - keys.begin())];
  if (dot == std::string::npos)
    place = std::move(value);
  else
    place.put(path.substr(dot + 1), std::move(value));
}

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    // U+0080 to U+009F are C2 80 to C2 9F in UTF-8.
    const bool is_c1 = byte == 0xC2 && next >= 0x80 && next < 0xA0;
    if (byte < 0x20 || byte == 0x7F || is_c1)
      out += fmt::format("\\u{:04x}", is_c1 ? next : byte);
    else
      out += text[i];
    if (is_c1) ++i;
  }
  return out;
}

std::string describe(const Value& value) {
  constexpr std::size_t kShown = 40;
  switch (value.kind) {
    case Value::Kind::kNull:
      return "null";
    case Value::Kind::kBoolean:
      return value.boolean ? "true" : "false";
    case Value::Kind::kNumber:
      return std::abs(value.number) < 1e15 && value.number == std::floor(value.number)
                 ? base::fixed(value.number, 0)
                 : base::shortest(value.number);
    case Value::Kind::kText: {
      if (value.text.size() <= kShown) return '"' + printable(value.text) + '"';
      // Does not cut inside a UTF-8 sequence.
      std::size_t cut = kShown;
      while (cut > 0 && (static_cast<unsigned char>(value.text[cut]) & 0xC0u) == 0x80u) --cut;
      return '"' + printable(value.text.substr(0, cut)) + "…\"";
    }
    case Value::Kind::kArray:
      return "a list";
    case Value::Kind::kObject:
      return "an object";
  }
  return {};
}

}  // namespace hedgehog::keys
