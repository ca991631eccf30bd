// SPDX-License-Identifier: MIT
#include "tests/protocol/schema_fields.h"

#include <cmath>

namespace hedgehog::protocol {
namespace {

Json number_json(double value) {
  if (value == std::trunc(value) && std::fabs(value) < 1e15)
    return {static_cast<std::int64_t>(value)};
  return {value};
}

}  // namespace

Json object(Json::Object members) { return {std::move(members)}; }
Json text_json(std::string_view text) { return {std::string(text)}; }

void SchemaFields::put(std::string name, Json value) {
  std::get<Json::Object>(stack_.back().json.value).emplace_back(std::move(name), std::move(value));
}

bool SchemaFields::open(std::string_view name, Presence presence, bool) {
  Level level;
  level.name = name;
  level.presence = presence;
  stack_.push_back(std::move(level));
  return true;
}

void SchemaFields::close() {
  Level level = std::move(stack_.back());
  stack_.pop_back();
  if (level.item) {
    put("items", std::move(level.json));
    return;
  }
  if (level.presence == Presence::kNullable) {
    level.json = object(
        {{"anyOf", {Json::List{std::move(level.json), object({{"type", text_json("null")}})}}}});
  }
  if (level.presence != Presence::kOptional)
    stack_.back().required.push_back(text_json(level.name));
  stack_.back().properties.emplace_back(level.name, std::move(level.json));
}

bool SchemaFields::begin_object() {
  put("type", text_json("object"));
  return true;
}

void SchemaFields::end_object() {
  Level& level = stack_.back();
  put("properties", {std::move(level.properties)});
  if (!level.required.empty()) put("required", {std::move(level.required)});
  level.properties.clear();
  level.required.clear();
  if (closed_) put("additionalProperties", {false});
}

std::size_t SchemaFields::begin_list(std::size_t, const Spec& spec) {
  put("type", text_json("array"));
  if (spec.items != Spec{}.items) put("maxItems", {static_cast<std::int64_t>(spec.items)});
  return 1;
}

bool SchemaFields::begin_item(std::size_t) {
  Level level;
  level.item = true;
  stack_.push_back(std::move(level));
  return true;
}

void SchemaFields::boolean(bool&) { put("type", text_json("boolean")); }

void SchemaFields::integer(std::int64_t&, const Spec& spec) {
  put("type", text_json(spec.rounded ? "number" : "integer"));
  Spec bounds = spec;
  // The limits of the C++ types are not limits of the protocol.
  if (std::fabs(bounds.min) > 1e15) bounds.min = -std::numeric_limits<double>::infinity();
  if (std::fabs(bounds.max) > 1e15) bounds.max = std::numeric_limits<double>::infinity();
  if (std::isfinite(bounds.min)) put("minimum", number_json(bounds.min));
  if (std::isfinite(bounds.max)) put("maximum", number_json(bounds.max));
}

void SchemaFields::number(double&, const Spec& spec) {
  put("type", text_json("number"));
  if (std::isfinite(spec.min)) put("minimum", number_json(spec.min));
  if (std::isfinite(spec.max)) put("maximum", number_json(spec.max));
}

void SchemaFields::text(std::string&, const Spec& spec) {
  put("type", text_json("string"));
  if (spec.min > 0) put("minLength", number_json(spec.min));
  if (std::isfinite(spec.max)) put("maxLength", number_json(spec.max));
}

void SchemaFields::enumerator(std::size_t&, std::span<const std::string_view> names) {
  Json::List list;
  for (const std::string_view name : names) list.push_back(text_json(name));
  put("enum", {std::move(list)});
}

void SchemaFields::numbers(std::span<double> v, const Spec&) {
  put("type", text_json("array"));
  put("items", object({{"type", text_json("number")}}));
  put("minItems", {static_cast<std::int64_t>(v.size())});
  put("maxItems", {static_cast<std::int64_t>(v.size())});
}

void SchemaFields::direction(Direction&) { put("$ref", text_json("#/$defs/Direction")); }

}  // namespace hedgehog::protocol
