// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/tunnel_arguments.h"

namespace hedgehog::client {

void add_tunnel_arguments(const cli::CommandSpec& tunnel, const cli::OptionSpec& general,
                          CommonOptions& common, TunnelOptions& options) {
  constexpr int kMaxPort = 65'535;
  tunnel
      .add_option("address", common.address,
                  "of the ball: tls://host:port or mdns://NAME; else HEDGEHOG_ADDRESS")
      .excludes(general);
  tunnel.add_option("--port", options.port, "of 127.0.0.1, for the games; 0: any free one")
      .range(0, kMaxPort)
      .show_default();
}

}  // namespace hedgehog::client
