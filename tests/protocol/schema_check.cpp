// SPDX-License-Identifier: MIT
// Reading and printing of schemas: the small part of JSON Schema that this protocol uses.
#include <algorithm>

#include "tests/protocol/child_path.h"
#include "tests/protocol/schema.h"

namespace hedgehog::protocol {
namespace {

bool is_of(const Json& value, const std::string& type) {
  if (type == "integer") return value.as<std::int64_t>() != nullptr;
  if (type == "number") return value.as<std::int64_t>() != nullptr || value.as<double>() != nullptr;
  constexpr std::string_view kTypes[] = {"null",   "boolean", "number", "number",
                                         "string", "array",   "object"};
  return kTypes[value.value.index()] == type;
}

double as_number(const Json& value) {
  const auto* integer = value.as<std::int64_t>();
  const auto* number = value.as<double>();
  return integer != nullptr ? static_cast<double>(*integer) : number != nullptr ? *number : 0.0;
}

class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  std::string check(const Json& schema, const Json& value, const std::string& path) const {
    const auto* text = value.as<std::string>();
    if (text != nullptr && *text == "…") return {};
    if (const Json* ref = schema.find("$ref")) {
      const std::string name = ref->as<std::string>()->substr(std::string("#/$defs/").size());
      return check(*root_.find("$defs")->find(name), value, path);
    }
    for (const auto& [keyword, rule] : *schema.as<Json::Object>())
      if (std::string broken = apply(keyword, rule, schema, value, path); !broken.empty())
        return broken;
    return {};
  }

 private:
  std::string apply(const std::string& keyword, const Json& rule, const Json& schema,
                    const Json& value, const std::string& path) const {
    if (keyword == "type") {
      const auto* many = rule.as<Json::List>();
      const bool good = many == nullptr
                            ? is_of(value, *rule.as<std::string>())
                            : std::any_of(many->begin(), many->end(), [&](const Json& one) {
                                return is_of(value, *one.as<std::string>());
                              });
      return good ? "" : path + ": type";
    }
    if (keyword == "anyOf") {
      std::string closest;
      for (const Json& one : *rule.as<Json::List>()) {
        const std::string broken = check(one, value, path);
        if (broken.empty()) return {};
        closest = std::max(closest, broken,
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
      }
      return closest;
    }
    if (keyword == "const") return to_text(rule) == to_text(value) ? "" : path + ": const";
    if (keyword == "enum") {
      const auto& allowed = *rule.as<Json::List>();
      const bool good = std::any_of(allowed.begin(), allowed.end(), [&](const Json& one) {
        return to_text(one) == to_text(value);
      });
      return good ? "" : path + ": enum";
    }
    if (keyword == "minimum" || keyword == "maximum") {
      const double bound = as_number(rule);
      const bool good =
          keyword == "minimum" ? as_number(value) >= bound : as_number(value) <= bound;
      return good ? "" : path + ": " + keyword;
    }
    if (keyword == "items") {
      for (const Json& item : *value.as<Json::List>())
        if (std::string broken = check(rule, item, path + "[]"); !broken.empty()) return broken;
    }
    if (keyword == "properties") return members(rule, schema, value, path);
    if (keyword == "required" && value.find("…") == nullptr) {
      for (const Json& name : *rule.as<Json::List>())
        if (value.find(*name.as<std::string>()) == nullptr)
          return child_path(path, *name.as<std::string>()) + ": required";
    }
    return {};
  }

  std::string members(const Json& rule, const Json& schema, const Json& value,
                      const std::string& path) const {
    const bool closed = schema.find("additionalProperties") != nullptr;
    for (const auto& [name, member] : *value.as<Json::Object>()) {
      const Json* property = rule.find(name);
      if (property == nullptr && closed) return child_path(path, name) + ": unknown";
      if (property != nullptr) {
        if (std::string broken = check(*property, member, child_path(path, name)); !broken.empty())
          return broken;
      }
    }
    return {};
  }

  const Json& root_;
};

void print(std::string& out, const Json& json, std::size_t indent) {
  constexpr std::size_t kLine = 100;
  const std::string compact = to_text(json);
  const auto* list = json.as<Json::List>();
  const auto* members = json.as<Json::Object>();
  if (compact.size() + indent <= kLine || (list == nullptr && members == nullptr)) {
    out += compact;
    return;
  }
  const std::string margin(indent + 1, ' ');
  std::string before = list != nullptr ? "[\n" : "{\n";
  const auto next = [&] {
    out += before + margin;
    before = ",\n";
  };
  if (list != nullptr) {
    for (const Json& item : *list) {
      next();
      print(out, item, indent + 1);
    }
  } else {
    for (const auto& [name, member] : *members) {
      next();
      append_string(out, name);
      out += ": ";
      print(out, member, indent + 1);
    }
  }
  out += '\n' + std::string(indent, ' ') + (list != nullptr ? ']' : '}');
}

}  // namespace

std::string pretty(const Json& json) {
  std::string out;
  print(out, json, 0);
  return out + '\n';
}

std::string violation(const Json& messages, const std::string& name, const Json& value) {
  return Validator(messages).check(*messages.find("$defs")->find(name), value, name);
}

}  // namespace hedgehog::protocol
