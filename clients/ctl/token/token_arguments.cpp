// SPDX-License-Identifier: MIT
#include "clients/ctl/token/token_arguments.h"
#include "cli/program.h"

namespace hedgehog::client {

void add_token_arguments(const cli::CommandSpec& token, TokenOptions& options,
                         const std::function<void(TokenVerb)>& chosen) {
  constexpr int kMaxValidDays = 36'500;
  token.require_commands(1, 1);
  token.accept_options_above();
  token.add_option("--state", options.state,
                   "the daemon's state directory; else that of the service, or one's own");
  const auto verb = [&](const char* name, const char* help, TokenVerb run) {
    const cli::CommandSpec command = token.add_command(name, help);
    command.on_given([chosen, run] { chosen(run); });
    return command;
  };
  const cli::CommandSpec add = verb("add", "makes a token and prints it, once", run_token_add);
  add.add_option("name", options.name, "of the client that gets it").required();
  add.add_option("--role", options.role, "observe, play or operate")
      .one_of({"observe", "play", "operate"})
      .show_default();
  verb("list", "names and roles of all tokens", run_token_list);
  verb("revoke", "removes a token; its connections end", run_token_revoke)
      .add_option("name", options.name, "as `token list` prints it")
      .required();
  const cli::CommandSpec certificate = verb(
      "certificate",
      "makes a self-signed certificate for TLS, unless there is one, and prints its fingerprint",
      run_token_certificate);
  certificate.add_option("--host", options.host, "its name or address; else this machine's name");
  certificate.add_option("--days", options.days, "how long it is valid")
      .range(1, kMaxValidDays)
      .show_default();
  certificate.add_flag("--replace", options.replace, "a new one, though there is one");
}

}  // namespace hedgehog::client
