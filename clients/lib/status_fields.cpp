// SPDX-License-Identifier: MIT
#include "clients/lib/status_fields.h"

#include "protocol/wire/names.h"

namespace hedgehog::client {

Outcome<protocol::StatusKeys> status_fields(const std::vector<std::string>& names) {
  if (names.empty()) return protocol::kTelemetryDefault;
  protocol::StatusKeys keys;
  for (const std::string& name : names) {
    const auto key = protocol::enumerator_named<protocol::StatusKey>(name);
    if (!key)
      return ClientError{Failure::kBadAddress, "fields: the status has no '" + name + "'", {}};
    keys.add(*key);
  }
  return keys;
}

}  // namespace hedgehog::client
