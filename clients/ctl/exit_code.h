// SPDX-License-Identifier: MIT
// How hedgehogctl says what went wrong, to its user and to the shell.
#pragma once

#include <string>
#include <string_view>

#include "clients/common/exit_code.h"
#include "clients/lib/client_error.h"

namespace hedgehog::client {

ExitCode exit_code_of(const ClientError& error) noexcept;

/// From here on every error is one JSON object on a line of stderr:
/// {"error":{"code":…,"message":…,"data":{"name":…,…}}}. `code` and `data` are the daemon's where
/// it refused something; else `code` is null and `data.name` says what kind it is: usage,
/// no_daemon, closed, timeout, protocol, no_input, bad_data or failed.
void report_errors_as_json() noexcept;

/// Prints "hedgehogctl: <message>", and what to do about it where that is known, to stderr. Returns
/// `exit_code_of`.
ExitCode complain(const ClientError& error);
/// `sentence` has the program's name and its verb. Returns kUsage.
ExitCode complain_of_usage(const std::string& sentence);
/// Prints "hedgehogctl: <message>" to stderr; as JSON it has this data.name.
void print_failure(std::string_view name, const std::string& message);

}  // namespace hedgehog::client
