// SPDX-License-Identifier: MIT
// The machine-readable protocol, generated from the descriptions that the daemon decodes with, and
// a validator for the part of JSON Schema that it uses.
#pragma once

#include <string>

#include "protocol/methods.h"
#include "protocol/wire/json.h"

namespace hedgehog::protocol {

/// The schema of a method's `params`: properties, required, additionalProperties false.
Json schema_of_params(Method method);

/// protocol/schema/messages.schema.json: JSON Schema 2020-12, `$defs` of every message.
Json messages_schema();
/// protocol/schema/openrpc.json: OpenRPC 1.3. Self-contained, since its tools resolve no files:
/// contains the definitions of the file above as components.
Json openrpc_document();

/// Indented, with short values on one line.
std::string pretty(const Json& json);

/// The name in `$defs` of the result of `method`.
std::string result_name(Method method);

/// Why `value` violates the schema `$defs/<name>` of `messages`; empty if it is valid. "…" matches
/// any value.
std::string violation(const Json& messages, const std::string& name, const Json& value);

}  // namespace hedgehog::protocol
