// SPDX-License-Identifier: MIT
// `hedgehogctl token`: access to the daemon from other machines. Each returns the exit code.
#pragma once

#include <optional>
#include <string>

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct TokenOptions {
  /// --state: the daemon's state directory; nullopt: see `state_folder`.
  std::optional<std::string> state;
  std::string name;
  std::string role = "play";
  /// For the certificate: a host's name or address, empty: this machine's; and its validity.
  std::string host;
  int days = 3650;
  bool replace = false;
};

/// Creates a token; prints it, once.
int run_token_add(const CommonOptions& common, const TokenOptions& options);
/// Prints names and roles.
int run_token_list(const CommonOptions& common, const TokenOptions& options);
int run_token_revoke(const CommonOptions& common, const TokenOptions& options);
/// Creates certificate and key unless they exist, or with `replace`; prints the fingerprint.
int run_token_certificate(const CommonOptions& common, const TokenOptions& options);

}  // namespace hedgehog::client
