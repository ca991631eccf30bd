// SPDX-License-Identifier: MIT
#include "tests/soak/summary.h"

#include "protocol/wire/error.h"

namespace hedgehog::soak {

std::string Summary::line() const {
  return std::to_string(requests) + " requests, " + std::to_string(starts) + " starts, " +
         std::to_string(kills) + " kills, " + std::to_string(connections) + " connections, " +
         std::to_string(checks) + " checks";
}

std::string Summary::text() const {
  const auto row = [](const std::string& name, std::uint64_t count) {
    return "  " + name + ": " + std::to_string(count) + "\n";
  };
  std::string text = row("rounds", rounds) + row("requests", requests) + row("starts", starts) +
                     row("SIGKILL", kills) + row("SIGTERM, SIGINT", stops) +
                     row("reloads", reloads) + row("connections", connections) +
                     row("notifications", notifications) + row("checks", checks) +
                     row("emergency stops that outlived a kill", latches) +
                     row("full disks", full_disks) + row("odd files", unusual_files);
  text += "  answers:\n";
  for (const auto& [code, count] : responses)
    text +=
        "  " + row(code == 0 ? std::string("result")
                             : std::string(protocol::name(static_cast<protocol::ErrorCode>(code))),
                   count);
  text += "  closed by the daemon:\n";
  for (const auto& [why, count] : closed) text += "  " + row(why, count);
  return text;
}

}  // namespace hedgehog::soak
