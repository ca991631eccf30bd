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

  /// One that obeys the schema, and so mostly the daemon. Every seventh is a notification.
  std::string valid();
  /// One with something wrong in it: a value, a name, a member, the nesting.
  std::string invalid();
  /// Of valid and invalid requests and of items that are no requests.
  std::string batch();
  /// `method` with these parameters (a JSON object) and an id of its own.
  std::string request(std::string_view method, std::string_view params = "{}");
  std::string notification(std::string_view method, std::string_view params = "{}");

  /// The number of an effect that later requests may name.
  void offer_effect(std::uint32_t effect);

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
  std::string odd_value();
  /// Unique: a number, a fraction or a string. In a batch also null: its responses have an order,
  /// so that each belongs to one request.
  std::string id();
  std::string joined(const Members& members);

  Random& random_;
  protocol::Json definitions_;
  std::vector<protocol::Json> schemas_;  // of the parameters, by method
  std::vector<std::uint32_t> effects_;
  std::int64_t last_id_ = 0;
  bool in_batch_ = false;
};

}  // namespace hedgehog::soak
