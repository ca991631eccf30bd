// SPDX-License-Identifier: MIT
// Random requests as JSON text, made from the schema of each method's parameters.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocol/methods.h"
#include "protocol/wire/json.h"
#include "tests/soak/random.h"

namespace hedgehog::soak {

class RequestGenerator {
 public:
  explicit RequestGenerator(Random& random);

  /// A request that conforms to the schema and is therefore mostly accepted. Every seventh is a
  /// notification.
  std::string valid();
  /// A request with an invalid value, name, member or nesting.
  std::string invalid();
  /// A batch of valid and invalid requests and of items that are no requests.
  std::string batch();
  /// `method` with these parameters (a JSON object) and a unique id.
  std::string request(std::string_view method, std::string_view params = "{}");
  std::string notification(std::string_view method, std::string_view params = "{}");

  /// The number of an effect that later requests may refer to.
  void add_effect(std::uint32_t effect);

 private:
  using Members = std::vector<std::pair<std::string, std::string>>;

  protocol::Method method();
  Members params(protocol::Method method);
  std::string value(std::string_view name, const protocol::Json& schema);
  std::string number(const protocol::Json& schema, bool whole);
  std::string text(std::string_view name);
  std::string object(const protocol::Json& schema);
  std::string list(std::string_view name, const protocol::Json& schema);
  std::string keyframes();
  std::string unusual_value();
  /// Unique: a number, a fraction or a string. In a batch also null: its responses are in order, so
  /// that each can be matched to one request.
  std::string id();
  std::string joined(const Members& members);

  Random& random_;
  protocol::Json definitions_;
  std::vector<protocol::Json> schemas_;  // schemas of the parameters, by method
  std::vector<std::uint32_t> effects_;
  std::int64_t last_id_ = 0;
  bool in_batch_ = false;
};

}  // namespace hedgehog::soak
