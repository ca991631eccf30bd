// SPDX-License-Identifier: MIT
// Errors of hedgehogctl: messages and exit codes.
#pragma once

#include <string>
#include <string_view>

#include "clients/common/exit_code.h"
#include "clients/lib/client_error.h"

namespace hedgehog::client {

ExitCode exit_code_of(const ClientError& error) noexcept;

/// From here on every error is one JSON object on a line of stderr:
/// {"error":{"code":…,"message":…,"data":{"name":…,…}}}. `code` and `data` are those of the
/// daemon's error response; otherwise `code` is null and `data.name` the kind: usage, no_daemon,
/// closed, timeout, protocol, no_input, bad_data or failed.
void report_errors_as_json() noexcept;

/// Prints "hedgehogctl: <message>", and a remedy if there is one, to stderr. Returns
/// `exit_code_of`.
ExitCode report_error(const ClientError& error);
/// `sentence` includes the program's name and its verb. Returns kUsage.
ExitCode report_usage_error(const std::string& sentence);
/// Prints "hedgehogctl: <message>" to stderr; as JSON with `name` as data.name.
void print_failure(std::string_view name, const std::string& message);

}  // namespace hedgehog::client
