// SPDX-License-Identifier: MIT
// Generates a JSON Schema from the description of a value.
#pragma once

#include <string>
#include <vector>

#include "protocol/methods.h"
#include "protocol/wire/json.h"

namespace hedgehog::protocol {

class SchemaFields final : public Fields {
 public:
  /// The schema of `value`, whose contents are overwritten.
  template <class T>
  static Json of(T value, bool closed) {
    SchemaFields fields(closed);
    fields.value(value);
    return std::move(fields.stack_.back().json);
  }

  bool has(std::string_view) const noexcept override { return true; }

 private:
  explicit SchemaFields(bool closed) : closed_(closed) { stack_.push_back({}); }

  bool open(std::string_view name, Presence presence, bool present) override;
  void close() override;
  bool begin_object() override;
  void end_object() override;
  std::size_t begin_list(std::size_t size, const Spec& spec) override;
  bool begin_item(std::size_t index) override;
  void end_list() override {}
  void boolean(bool& v) override;
  void integer(std::int64_t& v, const Spec& spec) override;
  void number(double& v, const Spec& spec) override;
  void text(std::string& v, const Spec& spec) override;
  void enumerator(std::size_t& index, std::span<const std::string_view> names) override;
  void numbers(std::span<double> v, const Spec& spec) override;
  void direction(Direction& v) override;

  struct Level {
    Json json{Json::Object{}};
    std::string name{};
    Presence presence = Presence::kRequired;
    bool item = false;
    Json::Object properties{};
    Json::List required{};
  };
  void put(std::string name, Json value);

  bool closed_;
  std::vector<Level> stack_{};
};

/// `{name: value, ...}`
Json object(Json::Object members);
Json text_json(std::string_view text);

}  // namespace hedgehog::protocol
