// SPDX-License-Identifier: MIT
// The machine-readable protocol, made from the same descriptions that the daemon decodes with, and
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
/// protocol/schema/openrpc.json: OpenRPC 1.3. Stands alone, since its tools resolve no files: has
/// the definitions of the file above as components.
Json openrpc_document();

/// Indented, with short values on one line.
std::string pretty(const Json& json);

/// The name in `$defs` of what `method` answers.
std::string result_name(Method method);

/// Why `value` breaks the schema `$defs/<name>` of `messages`; empty when it does not. "…" stands
/// for any value.
std::string violation(const Json& messages, const std::string& name, const Json& value);

}  // namespace hedgehog::protocol
