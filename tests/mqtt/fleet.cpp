// SPDX-License-Identifier: MIT
// Load of a broker by a fleet: `--balls` connections like hedgehog-mqtt's, each with a ball's
// telemetry and status (and a description with --description-bytes), and a subscriber that counts
// the messages; --qos 1 sends the telemetry as status and events are sent.
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "cli/program.h"
#include "clients/mqtt/broker.h"
#include "clients/mqtt/broker_address.h"
#include "clients/mqtt/topics.h"

namespace {

using namespace hedgehog;
using namespace hedgehog::mqtt;
using Clock = std::chrono::steady_clock;

struct Options {
  int balls = 10;
  int seconds = 10;
  double telemetry_hz = 1.0;
  int payload_bytes = 1000;
  int description_bytes = 0;
  int qos = 0;
  int broker_pid = 0;
};

/// Of a process: resident memory in MB, and processor time in seconds.
struct Usage {
  double resident_mb = 0.0;
  double processor_s = 0.0;
};

Usage usage_of(int pid) {
  Usage usage;
  if (pid == 0) return usage;
  const std::string folder = "/proc/" + std::to_string(pid);
  std::ifstream statm(folder + "/statm");
  double pages = 0.0;
  statm >> pages >> pages;
  usage.resident_mb = pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
  std::ifstream stat(folder + "/stat");
  std::string word;
  std::getline(stat, word, ')');
  double user = 0.0;
  double system = 0.0;
  for (int i = 0; i < 11; ++i) stat >> word;
  stat >> user >> system;
  usage.processor_s = (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  return usage;
}

/// Fetches the received messages; returns the number of those that are telemetry.
std::int64_t drain(Broker& broker) {
  std::int64_t telemetry = 0;
  while (const auto notice = broker.next())
    if (const auto* message = std::get_if<Message>(&*notice))
      telemetry += message->topic.ends_with("/telemetry") ? 1 : 0;
  return telemetry;
}

/// The same until there are `count`, or for 10 s.
std::int64_t drain_until(Broker& broker, std::int64_t count) {
  const auto deadline = Clock::now() + std::chrono::seconds(10);
  std::int64_t received = 0;
  while (received < count && Clock::now() < deadline) {
    received += drain(broker);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return received;
}

bool wait_for_connection(Broker& broker) {
  const auto deadline = Clock::now() + std::chrono::seconds(30);
  while (Clock::now() < deadline) {
    while (const auto notice = broker.next())
      if (std::holds_alternative<BrokerConnected>(*notice)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

std::string payload_of(int bytes) {
  return "{\"x\":\"" + std::string(static_cast<std::size_t>(bytes), 'x') + "\"}";
}

int measure(const BrokerOptions& base, const Options& options) {
  BrokerOptions counting = base;
  const std::string prefix = "fleet-" + std::to_string(::getpid());
  counting.client_id = prefix + "-counter";
  auto counter = Broker::open(counting).value();
  if (!wait_for_connection(*counter)) return EX_UNAVAILABLE;
  const Delivery delivery = options.qos == 0 ? Delivery::kQos0 : Delivery::kQos1;
  counter->subscribe(prefix + "/#", delivery);
  const std::string payload = payload_of(options.payload_bytes);
  const std::string description = payload_of(options.description_bytes);
  std::vector<std::unique_ptr<Broker>> balls;
  std::vector<Topics> topics;
  std::int64_t first = 0;
  for (int i = 0; i < options.balls; ++i) {
    topics.emplace_back(prefix, "ball-" + std::to_string(i));
    BrokerOptions one = base;
    one.client_id = prefix + "-" + topics.back().id();
    one.will = {.topic = topics.back().availability(), .payload = "offline", .retained = true};
    balls.push_back(Broker::open(one).value());
    if (!wait_for_connection(*balls.back())) {
      std::fprintf(stderr, "fleet: the broker took %d of %d balls\n", i, options.balls);
      return EX_UNAVAILABLE;
    }
    balls.back()->publish({.topic = topics.back().status(),
                           .payload = payload,
                           .delivery = Delivery::kQos1,
                           .retained = true});
    if (options.description_bytes > 0) {
      balls.back()->publish({.topic = topics.back().description(),
                             .payload = description,
                             .delivery = Delivery::kQos1,
                             .retained = true});
    }
    // Comes after what is retained, which is not part of the load.
    balls.back()->publish({.topic = topics.back().telemetry(), .payload = payload});
    first += drain(*counter);
  }
  std::int64_t sent = 0;
  std::int64_t received = 0;
  first += drain_until(*counter, options.balls - first);
  if (first < options.balls) {
    std::fprintf(stderr, "fleet: not every ball's first message came\n");
    return EX_UNAVAILABLE;
  }
  const Usage before = usage_of(options.broker_pid);
  const auto begun = Clock::now();
  const auto rounds = static_cast<int>(options.seconds * options.telemetry_hz);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Message message{
          .topic = topics[i].telemetry(), .payload = payload, .delivery = delivery};
      sent += balls[i]->publish(message) ? 1 : 0;
      received += drain(*counter);
      // Spread over the interval, as balls are not synchronised.
      const double at = (round + static_cast<double>(i + 1) / options.balls) / options.telemetry_hz;
      std::this_thread::sleep_until(begun + std::chrono::duration<double>(at));
    }
  }
  received += drain_until(*counter, sent - received);
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - begun).count();
  const Usage after = usage_of(options.broker_pid);
  const double share = 100.0 * (after.processor_s - before.processor_s) / elapsed_s;
  std::printf("%6d balls  %8.0f messages/s  %8.2f MB/s  lost %lld  broker: %5.1f %% of a core, ",
              options.balls, static_cast<double>(received) / elapsed_s,
              static_cast<double>(received) * options.payload_bytes / elapsed_s / 1e6,
              static_cast<long long>(sent - received), share);
  std::printf("%.1f MB\n", after.resident_mb);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app{"Measures what a fleet of balls costs an MQTT broker.", "mqtt_fleet"};
  Options options;
  std::string broker = "127.0.0.1";
  app.add_option("--broker", broker, "host[:port] or a socket's path").show_default();
  app.add_option("--broker-pid", options.broker_pid, "whose memory and processor time count");
  // libmosquitto waits by select(2), of 1024 descriptors at most; a ball has four.
  app.add_option("--balls", options.balls, "of this process; start several for more")
      .range(1, 250)
      .show_default();
  app.add_option("--seconds", options.seconds).range(1, 3600).show_default();
  app.add_option("--telemetry-hz", options.telemetry_hz).range(0.1, 200.0).show_default();
  app.add_option("--payload-bytes", options.payload_bytes).range(1, 60'000).show_default();
  app.add_option("--description-bytes", options.description_bytes,
                 "retained beside the status; 0: none")
      .range(0, 60'000)
      .show_default();
  app.add_option("--qos", options.qos, "1: as status and events are sent and received")
      .range(0, 1)
      .show_default();
  if (const auto code = app.parse_and_print(argc, argv)) return *code;
  BrokerOptions base;
  if (const auto set = set_address(base, broker); !set) {
    std::fprintf(stderr, "fleet: %s\n", set.error().message.c_str());
    return set.error().exit_code;
  }
  return measure(base, options);
}
