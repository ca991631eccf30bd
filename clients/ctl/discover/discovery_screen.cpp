// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/discovery_screen.h"

#include <nlohmann/json.hpp>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kDiscoveredColumns = 24;
constexpr std::size_t kStateColumns = 13;

std::string line_of(const std::string& name, const std::string& state, const std::string& address,
                    const ScreenStyle& style) {
  const auto cell = [&](const std::string& text, std::size_t width) {
    return left(style.cuts ? cut(text, width) : text, width) + "  ";
  };
  return "  " + cell(name, kDiscoveredColumns) + cell(state, kStateColumns) + address;
}

std::string name_of(const RespondingDaemon& found) {
  if (!found.hello) return found.daemon.instance;
  return found.hello->device.name + (found.hello->device.simulated ? " (simulated)" : "");
}

ordered_json value_of(const std::optional<std::string>& text) {
  return text ? ordered_json(*text) : ordered_json(nullptr);
}

ordered_json json_of(const RespondingDaemon& found) {
  ordered_json object{{"instance", found.daemon.instance}, {"address", found.daemon.socket}};
  if (!found.hello) {
    object["failure"] = found.failure;
    return object;
  }
  object["name"] = found.hello->device.name;
  object["model"] = found.hello->device.model;
  object["simulated"] = found.hello->device.simulated;
  object["state"] = found.hello->state;
  object["protocol"] = found.hello->protocol;
  object["serial"] = value_of(found.serial);
  return object;
}

ordered_json json_of(const DiscoveredBall& daemon) {
  return {{"name", daemon.name},
          {"host", daemon.host},
          {"address", to_string(daemon.address)},
          {"serial", value_of(daemon.serial)},
          {"protocol", value_of(daemon.protocol)},
          {"tls", daemon.address.tls}};
}

}  // namespace

std::vector<std::string> discovery_screen(const Discovery& discovery, const ScreenStyle& style) {
  std::vector<std::string> lines;
  for (const RespondingDaemon& found : discovery.local) {
    lines.push_back(line_of(name_of(found), found.hello ? found.hello->state : found.failure,
                            found.daemon.socket, style));
  }
  for (const DiscoveredBall& daemon : discovery.network.daemons) {
    lines.push_back(line_of(daemon.name, daemon.address.tls ? "network, TLS" : "network",
                            to_string(daemon.address), style));
  }
  if (lines.empty()) return {"  no ball was found"};
  lines.insert(lines.begin(), line_of("BALL", "STATE", "ADDRESS", style));
  return lines;
}

std::string discovery_json(const Discovery& discovery) {
  ordered_json object{{"local", ordered_json::array()}, {"network", ordered_json::array()}};
  for (const RespondingDaemon& found : discovery.local) object["local"].push_back(json_of(found));
  for (const DiscoveredBall& daemon : discovery.network.daemons)
    object["network"].push_back(json_of(daemon));
  object["network_failure"] = discovery.network.failure.empty()
                                  ? ordered_json(nullptr)
                                  : ordered_json(discovery.network.failure);
  return object.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace hedgehog::client
