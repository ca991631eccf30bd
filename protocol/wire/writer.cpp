// SPDX-License-Identifier: MIT
#include "protocol/wire/writer.h"

#include <array>
#include <cmath>

#include "protocol/wire/json.h"

namespace hedgehog::protocol {
namespace {

double power_of_ten(int exponent) {
  constexpr std::array<double, 8> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
  const auto index = static_cast<std::size_t>(exponent);
  return index < kPowers.size() ? kPowers[index] : std::pow(10.0, exponent);
}

double to_decimals(double value, int decimals) {
  if (decimals < 0) return value;
  const double scale = power_of_ten(decimals);
  const double scaled = std::round(value * scale) / scale;
  // Huge values have no decimals to round; scaling them may overflow.
  return std::isfinite(scaled) ? scaled : value;
}

}  // namespace

bool Writer::open(std::string_view name, Presence presence, bool present) {
  if (!present && presence != Presence::kNullable) return false;
  if (out_.back() != '{') out_ += ',';
  append_string(out_, name);
  out_ += ':';
  if (!present) out_ += "null";
  return present;
}

bool Writer::begin_object() {
  out_ += '{';
  return true;
}

void Writer::end_object() { out_ += '}'; }

std::size_t Writer::begin_list(std::size_t size, const Spec&) {
  out_ += '[';
  return size;
}

bool Writer::begin_item(std::size_t index) {
  if (index > 0) out_ += ',';
  return true;
}

void Writer::end_list() { out_ += ']'; }

void Writer::boolean(bool& v) { out_ += v ? "true" : "false"; }

void Writer::integer(std::int64_t& v, const Spec&) { append_integer(out_, v); }

void Writer::number(double& v, const Spec& spec) {
  append_number(out_, to_decimals(v, spec.decimals));
}

void Writer::text(std::string& v, const Spec&) { append_string(out_, v); }

void Writer::enumerator(std::size_t& index, std::span<const std::string_view> names) {
  append_string(out_, index < names.size() ? names[index] : std::string_view{});
}

void Writer::numbers(std::span<double> v, const Spec& spec) {
  char before = '[';
  for (double& item : v) {
    out_ += before;
    before = ',';
    number(item, spec);
  }
  out_ += ']';
}

}  // namespace hedgehog::protocol
