// SPDX-License-Identifier: MIT
#include "core/json.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace hedgehog::unreal {

namespace {

constexpr double kMaxExact = 9007199254740992.0;  // 2^53

void append_string(const std::string& text, std::string& out) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      out += escape;
    } else {
      out += c;
    }
  }
  out += '"';
}

void append_number(double number, std::string& out) {
  if (!std::isfinite(number)) {
    out += "null";
    return;
  }
  char digits[40];
  if (number == std::floor(number) && std::fabs(number) < kMaxExact)
    std::snprintf(digits, sizeof digits, "%.0f", number);
  else
    std::snprintf(digits, sizeof digits, "%.15g", number);
  // The user's locale may use another decimal point, of several bytes.
  bool in_point = false;
  for (const char* c = digits; *c != '\0'; ++c) {
    const bool digit = std::strchr("0123456789+-eE", *c) != nullptr;
    if (digit || !in_point) out += digit ? *c : '.';
    in_point = !digit;
  }
}

}  // namespace

Json Json::array(std::vector<Json> items) {
  Json value;
  value.kind_ = Kind::kArray;
  value.items_ = std::move(items);
  return value;
}

Json Json::object(std::vector<Field> fields) {
  Json value;
  value.kind_ = Kind::kObject;
  value.fields_ = std::move(fields);
  return value;
}

const Json& Json::operator[](std::string_view name) const {
  static const Json kNone;
  for (const Field& field : fields_)
    if (field.first == name) return field.second;
  return kNone;
}

void Json::set(std::string_view name, Json value) {
  kind_ = Kind::kObject;
  for (Field& field : fields_) {
    if (field.first == name) {
      field.second = std::move(value);
      return;
    }
  }
  fields_.emplace_back(std::string(name), std::move(value));
}

Json Json::without_nulls() const {
  Json given = Json::object();
  for (const Field& field : fields_)
    if (!field.second.is(Kind::kNull)) given.fields_.push_back(field);
  return given;
}

std::string Json::non_finite(const std::string& where) const {
  if (is(Kind::kNumber)) return std::isfinite(number_) ? std::string() : where;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const std::string found = items_[i].non_finite(where + "[" + std::to_string(i) + "]");
    if (!found.empty()) return found;
  }
  for (const Field& field : fields_) {
    const std::string found =
        field.second.non_finite(where.empty() ? field.first : where + "." + field.first);
    if (!found.empty()) return found;
  }
  return {};
}

std::string Json::to_text() const {
  std::string out;
  append_to(out);
  return out;
}

void Json::append_to(std::string& out) const {
  switch (kind_) {
    case Kind::kNull:
      out += "null";
      return;
    case Kind::kBool:
      out += truth_ ? "true" : "false";
      return;
    case Kind::kNumber:
      append_number(number_, out);
      return;
    case Kind::kString:
      append_string(text_, out);
      return;
    case Kind::kArray:
      out += '[';
      for (const Json& item : items_) {
        if (&item != &items_.front()) out += ',';
        item.append_to(out);
      }
      out += ']';
      return;
    case Kind::kObject:
      out += '{';
      for (const Field& field : fields_) {
        if (&field != &fields_.front()) out += ',';
        append_string(field.first, out);
        out += ':';
        field.second.append_to(out);
      }
      out += '}';
      return;
  }
}

// The order of fields is ignored.
bool operator==(const Json& a, const Json& b) {
  if (a.kind_ != b.kind_) return false;
  if (a.fields_.size() != b.fields_.size()) return false;
  for (const Json::Field& field : a.fields_) {
    bool found = false;
    for (const Json::Field& other : b.fields_)
      found = found || (other.first == field.first && other.second == field.second);
    if (!found) return false;
  }
  return a.truth_ == b.truth_ && a.number_ == b.number_ && a.text_ == b.text_ &&
         a.items_ == b.items_;
}

}  // namespace hedgehog::unreal
