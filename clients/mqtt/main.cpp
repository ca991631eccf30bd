// SPDX-License-Identifier: MIT
#include <cstdio>
#include <string>
#include <vector>

#include "cli/program.h"
#include "clients/common/arguments.h"
#include "clients/common/exit_code.h"
#include "clients/common/interrupts.h"
#include "clients/lib/status_fields.h"
#include "clients/mqtt/bridge.h"
#include "clients/mqtt/broker_address.h"

namespace {

using namespace hedgehog;
using namespace hedgehog::mqtt;

void print(const std::string& message) {
  std::fprintf(stderr, "hedgehog-mqtt: %s\n", message.c_str());
}

/// Rejects wildcards and empty levels, which would result in other topics.
std::string check_prefix(const std::string& prefix) {
  const bool fits = !prefix.empty() && prefix.find_first_of("+#") == std::string::npos &&
                    prefix.front() != '/' && prefix.back() != '/' && prefix.front() != '$';
  return fits ? std::string() : "is no prefix of topics: no + and #, no / at its ends, no $ first";
}

int run(const BridgeOptions& options) {
  Bridge bridge(options, print);
  const auto done = bridge.run([] { return client::interrupted(); });
  if (done) return kInterrupted;
  print(done.error().message);
  return done.error().exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app{
      "Publishes a ball's status, events and telemetry at an MQTT 5 broker, and plays the effects "
      "that its clients request.",
      "hedgehog-mqtt"};
  app.set_version(std::string("hedgehog-mqtt " HEDGEHOG_VERSION));
  BridgeOptions options;
  std::optional<std::string> address;
  std::string broker = "127.0.0.1";
  std::optional<std::string> password_file;
  std::vector<std::string> fields;
  std::string home_assistant = *options.home_assistant;
  app.add_option("--address", address, "host:port or a socket's path (HEDGEHOG_ADDRESS)");
  app.add_option("--token", options.token, "for the daemon, where it asks for one")
      .environment("HEDGEHOG_TOKEN");
  app.add_option("--broker", broker, "host[:port], mqtts://host[:port] or a socket's path")
      .show_default();
  app.add_option("--user", options.broker.user, "at the broker");
  app.add_option("--password-file", password_file,
                 "whose first line is the password (else HEDGEHOG_MQTT_PASSWORD)");
  app.add_option("--ca-file", options.broker.ca_file,
                 "certificates for mqtts:// instead of the system's");
  app.add_option("--keepalive-s", options.broker.keepalive_s,
                 "keep-alive interval: a broker silent for longer counts as disconnected")
      .range(5, 600)
      .show_default();
  app.add_option("--prefix", options.prefix, "what all topics begin with")
      .check({check_prefix})
      .show_default();
  app.add_option("--id", options.id, "of the ball in topics, instead of its serial number");
  app.add_option("--telemetry-hz", options.telemetry_hz, "0: none")
      .range(0.0, 200.0)
      .show_default();
  app.add_option("--fields", fields, "of telemetry, instead of the daemon's choice").delimiter(',');
  app.add_option("--status-s", options.status_s, "how often a status that did not change is sent")
      .range(0.5, 3600.0)
      .show_default();
  app.add_option("--home-assistant", home_assistant, "prefix of its discovery; no: none")
      .show_default();
  if (const auto code = client::parse_arguments(app, argc, argv)) return *code;
  if (home_assistant == "no")
    options.home_assistant.reset();
  else
    options.home_assistant = home_assistant;
  const auto addresses = client::daemon_addresses(address);
  if (!addresses) {
    print(addresses.error().message);
    return kUsage;
  }
  options.addresses = *addresses;
  const auto keys = client::status_fields(fields);
  if (!keys) {
    print(keys.error().message);
    return kUsage;
  }
  options.fields = *keys;
  if (auto set = set_address(options.broker, broker); !set) {
    print(set.error().message);
    return set.error().exit_code;
  }
  options.broker.password = client::process_environment("HEDGEHOG_MQTT_PASSWORD");
  if (password_file) {
    auto password = password_of(*password_file);
    if (!password) {
      print(password.error().message);
      return password.error().exit_code;
    }
    options.broker.password = *std::move(password);
  }
  client::watch_interrupts();
  return run(options);
}
