// SPDX-License-Identifier: MIT
// How hedgehogctl says what went wrong, to its user and to the shell.
#pragma once

#include "clients/common/exit_code.h"
#include "clients/lib/client_error.h"

namespace hedgehog::client {

ExitCode exit_code_of(const ClientError& error) noexcept;

/// Prints "hedgehogctl: <message>", and what to do about it where that is known, to stderr. Returns
/// `exit_code_of`.
ExitCode complain(const ClientError& error);

}  // namespace hedgehog::client
