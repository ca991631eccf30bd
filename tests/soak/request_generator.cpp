// SPDX-License-Identifier: MIT
#include "tests/soak/request_generator.h"

#include <algorithm>
#include <array>
#include <set>

#include "tests/soak/json_text.h"
#include "tests/soak/sample_values.h"

namespace hedgehog::soak {
namespace {

/// At most one member of each group is given.
constexpr std::array<std::array<std::string_view, 3>, 5> kExclusive{
    {{"level", "current_a", "force_n"},
     {"duration_ms", "lease_ms", ""},
     {"delay_ms", "start_at_ns", ""},
     {"effect", "slot", ""},
     {"pattern", "keyframes", ""}}};

/// Relative frequency of each method; 10 if not listed.
int weight(std::string_view method) {
  if (method == "device.emergency_stop" || method == "device.claim" || method == "sim.set" ||
      method == "device.enter_boot_loader" || method == "device.list")
    return 2;
  if (method == "effect.preview" || method == "pattern.put" || method == "pattern.remove") return 5;
  if (method.starts_with("effect.") || method == "device.arm") return 30;
  return 10;
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

}  // namespace

RequestGenerator::RequestGenerator(Random& random)
    : random_(random), definitions_(message_definitions()) {
  for (std::size_t i = 0; i < protocol::kMethods.size(); ++i)
    schemas_.push_back(protocol::schema_of_params(static_cast<protocol::Method>(i)));
}

void RequestGenerator::add_effect(std::uint32_t effect) {
  constexpr std::size_t kMaxEffects = 64;
  if (effects_.size() < kMaxEffects)
    effects_.push_back(effect);
  else
    effects_[effect % kMaxEffects] = effect;
}

protocol::Method RequestGenerator::method() {
  int all = 0;
  for (const auto& row : protocol::kMethods) all += weight(row.name);
  auto left = static_cast<int>(random_.below(static_cast<std::size_t>(all)));
  std::size_t chosen = 0;
  while ((left -= weight(protocol::kMethods[chosen].name)) >= 0) ++chosen;
  return static_cast<protocol::Method>(chosen);
}

std::string RequestGenerator::id() {
  const std::int64_t next = ++last_id_;
  switch (random_.below(8)) {
    case 0:
      return json_string("id-" + std::to_string(next));
    case 1:
      return json_string("Größe \"🦔\"\t" + std::to_string(next));
    case 2:
      return std::to_string(-next);
    case 3:
      return std::to_string(next) + ".5";
    case 4:
      return std::to_string(9'007'199'254'740'992 - next);
    case 5:
      return in_batch_ && random_.percent(30) ? "null" : std::to_string(next);
    default:
      return std::to_string(next);
  }
}

std::string RequestGenerator::number(const protocol::Json& schema, bool is_integer) {
  const auto bound = [&](std::string_view name, double otherwise) {
    const protocol::Json* given = schema.find(name);
    if (given == nullptr) return otherwise;
    const auto* integer = given->as<std::int64_t>();
    return integer != nullptr ? static_cast<double>(*integer) : *given->as<double>();
  };
  const double low = bound("minimum", -10.0);
  const double high = bound("maximum", std::max(low, 0.0) + 20.0);
  const double at = random_.percent(5) ? 0.0 : random_.percent(5) ? 1.0 : random_.unit();
  const double made = low + at * (high - low);
  std::string text;
  if (is_integer)
    text = std::to_string(static_cast<std::int64_t>(made));
  else
    protocol::append_number(text, made);
  return text;
}

std::string RequestGenerator::text(std::string_view name) {
  const std::vector<std::string>& known = sample_texts(name);
  if (!known.empty()) return json_string(random_.pick(known));
  return json_string(random_.percent(80) ? "Soak" : std::string(random_.below(300), 'y'));
}

std::string RequestGenerator::keyframes() {
  const std::size_t count = random_.percent(5) ? 256 : 1 + random_.below(8);
  std::int64_t t_ms = random_.percent(50) ? 0 : random_.between(0, 50);
  std::string made;
  for (std::size_t i = 0; i < count; ++i) {
    made += (i == 0 ? "[" : ",") + std::string("{\"t_ms\":") + std::to_string(t_ms);
    made += ",\"level\":" + std::to_string(random_.unit());
    if (random_.percent(20)) made += R"(,"direction":)" + value("direction", definitions_);
    if (random_.percent(20)) made += R"(,"ease":"smooth")";
    made += "}";
    t_ms += random_.between(1, 200);
  }
  return made + "]";
}

std::string RequestGenerator::list(std::string_view name, const protocol::Json& schema) {
  const protocol::Json* items = schema.find("items");
  const protocol::Json* fixed = schema.find("minItems");
  const std::size_t count =
      fixed != nullptr ? static_cast<std::size_t>(*fixed->as<std::int64_t>()) : random_.below(4);
  std::string made = "[";
  for (std::size_t i = 0; i < count; ++i) made += (i == 0 ? "" : ",") + value(name, *items);
  return made + "]";
}

std::string RequestGenerator::object(const protocol::Json& schema) {
  const protocol::Json* properties = schema.find("properties");
  if (properties == nullptr) return "{}";
  const protocol::Json* required = schema.find("required");
  Members members;
  for (const auto& [name, property] : *properties->as<protocol::Json::Object>()) {
    const auto is_name = [&, &key = name](const protocol::Json& one) {
      return *one.as<std::string>() == key;
    };
    const bool must =
        required != nullptr && std::any_of(required->as<protocol::Json::List>()->begin(),
                                           required->as<protocol::Json::List>()->end(), is_name);
    if (must || random_.percent(40)) members.emplace_back(name, value(name, property));
  }
  return joined(members);
}

std::string RequestGenerator::value(std::string_view name, const protocol::Json& schema) {
  if (name == "direction" || name == "axis" || name == "rotate_to") {
    const protocol::Json& forms = *definitions_.find("$defs")->find("Direction")->find("anyOf");
    return value("", random_.pick(*forms.as<protocol::Json::List>()));
  }
  if (name == "keyframes") return keyframes();
  if (name == "quaternion" || name == "orientation") return random_.pick(sample_quaternions());
  if (name == "pin") return std::to_string(random_.below(90));
  if (name == "effect" && !effects_.empty() && random_.percent(80))
    return std::to_string(random_.pick(effects_));
  if (const protocol::Json* options = schema.find("enum"))
    return protocol::to_text(random_.pick(*options->as<protocol::Json::List>()));
  if (const protocol::Json* forms = schema.find("anyOf"))
    return value(name, random_.pick(*forms->as<protocol::Json::List>()));
  const protocol::Json* type = schema.find("type");
  const std::string kind = type != nullptr ? *type->as<std::string>() : "null";
  if (kind == "number" || kind == "integer") return number(schema, kind == "integer");
  if (kind == "boolean") return random_.percent(50) ? "true" : "false";
  if (kind == "string") return text(name);
  if (kind == "array") return list(name, schema);
  if (kind == "object") return object(schema);
  return "null";
}

RequestGenerator::Members RequestGenerator::params(protocol::Method method) {
  const protocol::Json& schema = schemas_[static_cast<std::size_t>(method)];
  const std::string_view called = protocol::name(method);
  if (called == "effect.preview" || (called == "thermal.forecast" && random_.percent(40))) {
    const auto planned = protocol::method_named("effect.vibrate");
    return {{"method", json_string("effect.vibrate")}, {"params", joined(params(*planned))}};
  }
  std::set<std::string> must;
  if (const protocol::Json* required = schema.find("required"))
    for (const protocol::Json& one : *required->as<protocol::Json::List>())
      must.insert(*one.as<std::string>());
  // Exactly one member selects the effect, and exactly one the content to play.
  const bool names_effect = called == "effect.stop" || called == "effect.update";
  if (names_effect) must.insert(random_.percent(70) ? "slot" : "effect");
  if (called == "effect.play") must.insert(random_.percent(70) ? "pattern" : "keyframes");
  if (called == "thermal.forecast") must.insert(random_.percent(70) ? "current_a" : "effect");

  std::set<std::string_view> excluded{"method", "params"};
  const auto exclude_others = [&](std::string_view name) {
    for (const auto& group : kExclusive)
      if (std::find(group.begin(), group.end(), name) != group.end())
        excluded.insert(group.begin(), group.end());
  };
  for (const std::string& name : must) exclude_others(name);
  Members made;
  const auto& properties = *schema.find("properties")->as<protocol::Json::Object>();
  // Starts at a random member, so that no member of a group is always the first.
  const std::size_t first = properties.empty() ? 0 : random_.below(properties.size());
  for (std::size_t i = 0; i < properties.size(); ++i) {
    const auto& [name, property] = properties[(first + i) % properties.size()];
    const bool chosen = random_.percent(15) && !excluded.contains(name);
    if (!chosen && !must.contains(name)) continue;
    exclude_others(name);
    made.emplace_back(name, value(name, property));
  }
  return made;
}

std::string RequestGenerator::joined(const Members& members) {
  std::string made;
  for (const auto& [name, value] : members)
    made += (made.empty() ? "{" : ",") + json_string(name) + ":" + value;
  return made.empty() ? "{}" : made + "}";
}

std::string RequestGenerator::request(std::string_view method, std::string_view params) {
  return R"({"jsonrpc":"2.0","id":)" + id() + R"(,"method":)" + json_string(method) +
         R"(,"params":)" + std::string(params) + "}";
}

std::string RequestGenerator::notification(std::string_view method, std::string_view params) {
  return R"({"jsonrpc":"2.0","method":)" + json_string(method) + R"(,"params":)" +
         std::string(params) + "}";
}

std::string RequestGenerator::valid() {
  const protocol::Method called = method();
  const std::string given = joined(params(called));
  return random_.below(7) == 0 ? notification(protocol::name(called), given)
                               : request(protocol::name(called), given);
}

std::string RequestGenerator::unusual_value() {
  if (random_.percent(5)) return nested(20 + random_.below(30));
  if (random_.percent(3)) return json_string(std::string(30'000, 'z'));
  return random_.pick(unusual_values());
}

std::string RequestGenerator::invalid() {
  protocol::Method called = method();
  Members given = params(called);
  std::string name(protocol::name(called));
  switch (random_.below(8)) {
    case 0:
      given.emplace_back("no_such", unusual_value());
      break;
    case 1:
      if (!given.empty()) given.push_back(given[random_.below(given.size())]);
      break;
    case 2:
      if (!given.empty())
        given.erase(given.begin() + static_cast<long>(random_.below(given.size())));
      break;
    case 3:
      name[random_.below(name.size())] = '_';
      break;
    case 4:
      return request(name, unusual_value());
    case 5:
      return random_.pick(no_requests());
    default:
      if (!given.empty())
        given[random_.below(given.size())].second = unusual_value();
      else
        given.emplace_back("x", unusual_value());
  }
  return request(name, joined(given));
}

std::string RequestGenerator::batch() {
  constexpr std::size_t kMaxItems = 64;
  const std::size_t count = random_.percent(5)    ? kMaxItems + random_.below(3)
                            : random_.percent(10) ? kMaxItems - random_.below(3)
                                                  : 1 + random_.below(8);
  in_batch_ = true;
  std::string made;
  for (std::size_t i = 0; i < count; ++i)
    made += (i == 0 ? "[" : ",") + (random_.percent(85) ? valid() : invalid());
  in_batch_ = false;
  return made + "]";
}

}  // namespace hedgehog::soak
