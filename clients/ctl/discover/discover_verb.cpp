// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/discover_verb.h"

#include <cstdio>

#include "clients/common/terminal.h"
#include "clients/ctl/discover/discovery_screen.h"
#include "clients/ctl/exit_code.h"

namespace hedgehog::client {

int run_discover(bool as_json) {
  const Discovery discovery{search_machine(), search_network()};
  if (as_json) {
    std::puts(discovery_json(discovery).c_str());
  } else {
    const TerminalTraits traits = terminal_traits();
    for (const std::string& line :
         discovery_screen(discovery, {.ascii = traits.ascii, .cuts = traits.has_edge}))
      std::puts(line.c_str());
    if (!discovery.network.failure.empty())
      std::fprintf(stderr, "hedgehogctl: %s\n", discovery.network.failure.c_str());
  }
  return discovery.local.empty() && discovery.network.daemons.empty() ? kUnavailable : kDone;
}

}  // namespace hedgehog::client
