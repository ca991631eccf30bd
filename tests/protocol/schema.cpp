// SPDX-License-Identifier: MIT
#include "tests/protocol/schema.h"

#include <algorithm>
#include <cctype>

#include "protocol/values/event.h"
#include "tests/protocol/schema_fields.h"
#include "tests/protocol/schema_text.h"

namespace hedgehog::protocol {
namespace {

Json::Object& members(Json& json) { return std::get<Json::Object>(json.value); }

Json* member(Json& json, std::string_view name) {
  return const_cast<Json*>(std::as_const(json).find(name));
}

Json type(std::string_view name) { return object({{"type", text_json(name)}}); }
Json ref(const std::string& name) { return object({{"$ref", text_json("#/$defs/" + name)}}); }
Json constant(std::string_view text) { return object({{"const", text_json(text)}}); }

Json list(std::initializer_list<std::string_view> texts) {
  Json::List items;
  for (const std::string_view text : texts) items.push_back(text_json(text));
  return {std::move(items)};
}

/// The members that every message has; all others depend on the case.
void require_only(Json& schema, std::initializer_list<std::string_view> names) {
  *member(schema, "required") = list(names);
}

Json direction_schema() {
  Json enumerator = SchemaFields::of(Word{}, true);
  Json vector = SchemaFields::of(model::Vec3{}, true);
  Json pin = SchemaFields::of(PinNumber{}, true);
  Json angles = SchemaFields::of(Angles{}, true);
  return object({{"anyOf", {Json::List{enumerator, vector, pin, angles}}}});
}

Json error_schema() {
  Json data =
      object({{"type", text_json("object")},
              {"properties",
               object({{"name", type("string")},
                       {"field", type("string")},
                       {"limit", object({})},
                       {"value", object({})},
                       {"state", type("string")},
                       {"reason", type("string")},
                       {"remedy", type("string")},
                       {"role_needed", object({{"enum", list({"observe", "play", "operate"})}})},
                       {"retry_after_ms", type("integer")},
                       {"device", object({{"enum", list({"board", "imu"})}})},
                       {"limit_a", type("number")}})},
              {"required", list({"name"})}});
  return object({{"type", text_json("object")},
                 {"properties", object({{"code", type("integer")},
                                        {"message", type("string")},
                                        {"data", std::move(data)}})},
                 {"required", list({"code", "message", "data"})}});
}

Json request_schema(const MethodInfo& row) {
  return object(
      {{"type", text_json("object")},
       {"properties", object({{"jsonrpc", constant("2.0")},
                              {"id", object({{"type", list({"string", "number", "null"})}})},
                              {"method", constant(row.name)},
                              {"params", schema_of_params(*method_named(row.name))}})},
       {"required", list({"jsonrpc", "method"})}});
}

Json notification_schema(std::string_view method, const std::string& params) {
  return object({{"type", text_json("object")},
                 {"properties", object({{"jsonrpc", constant("2.0")},
                                        {"method", constant(method)},
                                        {"params", ref(params)}})},
                 {"required", list({"jsonrpc", "method", "params"})}});
}

Json event_schema() {
  Json schema = SchemaFields::of(Event{}, false);
  require_only(schema, {"type", "time_ns"});
  Json::List names;
  for (const std::string_view name : kEventTypes) names.push_back(text_json(name));
  // Examples, not an enum: clients must accept types that they do not know yet.
  members(*member(*member(schema, "properties"), "type")).emplace_back("examples", Json{names});
  return schema;
}

Json history_schema() {
  Json schema = SchemaFields::of(HistoryResult{}, false);
  Json& item = *member(*member(*member(schema, "properties"), "events"), "items");
  require_only(item, {"at", "type", "time_ns"});
  return schema;
}

/// The `$defs` of messages.schema.json become components of OpenRPC.
void refer_to_components(Json& json) {
  constexpr std::string_view kDefinitions = "#/$defs/";
  if (auto* list = std::get_if<Json::List>(&json.value)) {
    for (Json& item : *list) refer_to_components(item);
  } else if (auto* object = std::get_if<Json::Object>(&json.value)) {
    for (auto& [name, value] : *object) {
      const auto* text = value.as<std::string>();
      if (name == "$ref" && text != nullptr && text->starts_with(kDefinitions))
        value = text_json("#/components/schemas/" + text->substr(kDefinitions.size()));
      else
        refer_to_components(value);
    }
  }
}

/// "telemetry.history" as generators name the type of that method: "TelemetryHistory".
std::string type_name(std::string_view method) {
  std::string name;
  bool begins = true;
  for (const char letter : method) {
    const bool between = letter == '.' || letter == '_';
    if (!between)
      name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    begins = between;
  }
  return name;
}

/// The title of a definition, from which generators make a type: differs from the types of all
/// methods.
std::string title_of(const std::string& definition) {
  const bool taken = std::any_of(kMethods.begin(), kMethods.end(), [&](const MethodInfo& row) {
    return type_name(row.name) == definition;
  });
  return taken ? definition + "Result" : definition;
}

/// The errors of JSON-RPC by the protocol's names.
Json errors_of_all_methods() {
  Json::Object errors;
  for (const ErrorCode code : kErrorCodes)
    errors.emplace_back(std::string(name(code)),
                        object({{"code", {std::int64_t{static_cast<int>(code)}}},
                                {"message", text_json(meaning_of(code))},
                                {"data", object({{"name", text_json(name(code))}})}}));
  return {std::move(errors)};
}

Json errors_of(const MethodInfo& row) {
  Json::List errors;
  for (const ErrorCode code : kErrorCodes)
    if (possible_errors(row).contains(code))
      errors.push_back(
          object({{"$ref", text_json("#/components/errors/" + std::string(name(code)))}}));
  return {std::move(errors)};
}

/// Every definition of messages.schema.json that is not a whole message, named for generators.
Json components() {
  const Json messages = messages_schema();
  Json::Object schemas;
  for (const auto& [name, definition] : *messages.find("$defs")->as<Json::Object>()) {
    if (name == "Request" || name == "Notification") continue;
    Json schema = definition;
    refer_to_components(schema);
    members(schema).insert(members(schema).begin(), {"title", text_json(title_of(name))});
    schemas.emplace_back(name, std::move(schema));
  }
  return object({{"schemas", {std::move(schemas)}}, {"errors", errors_of_all_methods()}});
}

}  // namespace

Json schema_of_params(Method method) {
  Request request = empty_request(method);
  Json schema =
      std::visit([](const auto& value) { return SchemaFields::of(value, true); }, request);
  const bool preview = std::holds_alternative<EffectPreview>(request);
  const bool planned = preview || std::holds_alternative<ThermalForecast>(request);
  for (auto& [name, property] : members(*member(schema, "properties"))) {
    if (planned && name == "params") property = type("object");
    if (const std::string_view meaning = meaning_of(name); !meaning.empty())
      members(property).emplace_back("description", text_json(meaning));
  }
  if (preview) members(schema).emplace_back("required", list({"method", "params"}));
  const auto* start = std::get_if<EffectStart>(&request);
  if (start != nullptr &&
      (start->method == model::EffectMethod::kPulse || start->method == model::EffectMethod::kHold))
    members(schema).emplace_back("required", list({"direction"}));
  return schema;
}

std::string result_name(Method method) {
  return std::visit([]<class R>(const R&) { return std::string(R::Result::kSchema); },
                    empty_request(method));
}

namespace {

template <class Result>
Json result_schema() {
  if constexpr (std::is_same_v<Result, HistoryResult>) return history_schema();
  if constexpr (std::is_same_v<Result, Done>) return type("object");
  Json schema = SchemaFields::of(Result{}, false);
  if constexpr (std::is_same_v<Result, Status>) {
    auto& required = std::get<Json::List>(member(schema, "required")->value);
    std::erase_if(required, [](const Json& name) { return *name.as<std::string>() == "pins"; });
  }
  return schema;
}

template <class... All>
void add_results(Json::Object& definitions, TypeList<All...>) {
  (definitions.emplace_back(std::string(All::kSchema), result_schema<All>()), ...);
}

}  // namespace

Json messages_schema() {
  Json telemetry = SchemaFields::of(Telemetry{kEveryStatusKey, {}}, false);
  require_only(telemetry, {"time_ns"});
  Json::List requests;
  for (const MethodInfo& row : kMethods) requests.push_back(request_schema(row));
  Json::Object definitions{{"Direction", direction_schema()}};
  add_results(definitions, Results{});
  definitions.emplace_back("Telemetry", std::move(telemetry));
  definitions.emplace_back("Event", event_schema());
  definitions.emplace_back("Error", error_schema());
  definitions.emplace_back("Request", object({{"anyOf", {std::move(requests)}}}));
  definitions.emplace_back("Notification",
                           object({{"anyOf",
                                    {Json::List{notification_schema("telemetry", "Telemetry"),
                                                notification_schema("event", "Event")}}}}));
  return object({{"$schema", text_json("https://json-schema.org/draft/2020-12/schema")},
                 {"title", text_json("Hedgehog protocol 1.0: every message")},
                 {"$defs", object(std::move(definitions))}});
}

Json openrpc_document() {
  Json::List methods;
  for (const MethodInfo& row : kMethods) {
    const Json schema = schema_of_params(*method_named(row.name));
    const Json* needed = schema.find("required");
    Json::List params;
    for (const auto& [name, property] : *schema.find("properties")->as<Json::Object>()) {
      const bool must =
          needed != nullptr &&
          std::any_of(needed->as<Json::List>()->begin(), needed->as<Json::List>()->end(),
                      [&wanted = name](const Json& n) { return *n.as<std::string>() == wanted; });
      Json described = property;
      refer_to_components(described);
      params.push_back(object(
          {{"name", text_json(name)}, {"required", {must}}, {"schema", std::move(described)}}));
    }
    // The specification's order, which is the parameter order of a generated function.
    std::stable_partition(params.begin(), params.end(),
                          [](const Json& param) { return *param.find("required")->as<bool>(); });
    const std::string result = result_name(*method_named(row.name));
    methods.push_back(object(
        {{"name", text_json(row.name)},
         {"summary", text_json(row.summary)},
         {"paramStructure", text_json("by-name")},
         {"x-role", row.role ? text_json(name(*row.role)) : Json{}},
         {"params", {std::move(params)}},
         {"result",
          object({{"name", text_json(result)},
                  {"schema", object({{"$ref", text_json("#/components/schemas/" + result)}})}})},
         {"errors", errors_of(row)}}));
  }
  return object(
      {{"openrpc", text_json("1.3.2")},
       {"info", object({{"title", text_json("Hedgehog")}, {"version", text_json("1.0")}})},
       {"methods", {std::move(methods)}},
       {"components", components()}});
}

}  // namespace hedgehog::protocol
