// SPDX-License-Identifier: MIT
// `hedgehogctl tunnel`: a ball on the network at a port of this machine, for games without TLS.
#pragma once

#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

struct TunnelOptions {
  /// 0: any free one.
  int port = kDefaultPort;
};

/// Returns the exit code: kInterrupted after Ctrl-C.
int run_tunnel(const CommonOptions& common, const TunnelOptions& options);

}  // namespace hedgehog::client
