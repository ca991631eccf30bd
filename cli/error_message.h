// SPDX-License-Identifier: MIT
// Error messages for a command line, one sentence.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
class ParseError;
}  // namespace CLI

namespace hedgehog::cli {

/// "there is no verb 'pulze'; did you mean 'pulse'?", "unknown option '--loud'", or CLI11's
/// message. `error`: thrown by `app.parse`.
std::string error_message(const CLI::App& app, const CLI::ParseError& error);

/// "hedgehogctl pulse: <what>; see hedgehogctl pulse --help", with the verbs that were given.
std::string usage_error(const CLI::App& app, const std::string& what);

}  // namespace hedgehog::cli
