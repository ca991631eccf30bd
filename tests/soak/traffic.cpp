// SPDX-License-Identifier: MIT
#include "tests/soak/traffic.h"

#include <poll.h>
#include <sys/wait.h>

#include <algorithm>
#include <vector>

#include "tests/soak/failure.h"

namespace hedgehog::soak {
namespace {

/// At one ping per millisecond, more than any timeout that the daemon documents.
constexpr int kMaxPings = 60'000;

}  // namespace

Traffic::Traffic(e2e::DaemonProcess& daemon, const e2e::Home& home, RequestGenerator& generator,
                 Summary& summary, double current_a)
    : daemon_(daemon),
      home_(home),
      generator_(generator),
      summary_(summary),
      log_(home.path("log")),
      endpoints_{daemon.port(), daemon.http_port(), daemon.socket()},
      watcher_(Transport::kUnix, endpoints_, 0),
      control_(daemon.socket()),
      current_a_(current_a) {
  watcher_.send(generator.request("hello", R"({"client":"watcher"})"));
  watcher_.send(generator.request("events.subscribe", R"({"scope":"all"})"));
  pump_until([&] { return watcher_.pending() == 0; }, [] { return "the watcher"; });
}

Peer* Traffic::peer(std::size_t place) {
  Peer* const found = places_[place].get();
  return found != nullptr && found->is_open() ? found : nullptr;
}

Peer& Traffic::connect(std::size_t place, Transport transport, int receive_buffer) {
  places_[place] = std::make_unique<Peer>(transport, endpoints_, receive_buffer);
  Peer& peer = *places_[place];
  ++summary_.connections;
  if (transport == Transport::kHttp)
    peer.allow_close("HTTP");
  else
    send(peer, generator_.request("hello", R"({"client":"soak","protocol":"1.0"})"));
  return peer;
}

void Traffic::connect_foreign(std::size_t place, Transport transport, const std::string& bytes) {
  places_[place] = std::make_unique<Peer>(transport, endpoints_, 0);
  ++summary_.connections;
  places_[place]->allow_close("a first byte that begins no request");
  places_[place]->send_bytes(bytes);
}

void Traffic::send(Peer& peer, const std::string& message, int fragments) {
  constexpr std::size_t kMaxUnsent = std::size_t{4} << 20;
  if (peer.unsent_bytes() > kMaxUnsent) return;
  summary_.requests += protocol::decode_line(message).items.size();
  peer.send(message, fragments);
}

bool Traffic::pump(int timeout_ms) {
  std::vector<pollfd> waiting;
  std::vector<Peer*> peers;
  const auto add = [&](Peer& peer) {
    const int events = (peer.can_read() ? POLLIN : 0) | (peer.can_write() ? POLLOUT : 0);
    if (!peer.is_open() || events == 0) return;
    waiting.push_back({peer.fd(), static_cast<short>(events), 0});
    peers.push_back(&peer);
  };
  add(watcher_);
  for_each_peer(add);
  if (::poll(waiting.data(), waiting.size(), timeout_ms) <= 0) return false;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    if (waiting[i].revents == 0) continue;
    const bool readable = peers[i]->reads() && (waiting[i].revents & ~POLLOUT) != 0;
    peers[i]->exchange(readable, (waiting[i].revents & ~POLLIN) != 0, *this);
    if (peers[i]->is_closed_by_daemon()) on_close(*peers[i]);
  }
  return true;
}

void Traffic::pump_until(const std::function<bool()>& done,
                         const std::function<std::string()>& what) {
  for (int pings = 0; pings < kMaxPings; ++pings) {
    while (pump()) {
    }
    if (done()) return;
    check_alive();
    control_.call("ping");
    pump(1);
  }
  throw Failure(what() + " is still missing after " + std::to_string(kMaxPings) + " pings");
}

void Traffic::check_alive() {
  siginfo_t end{};
  ::waitid(P_PID, static_cast<id_t>(daemon_.pid()), &end, WEXITED | WNOHANG | WNOWAIT);
  if (end.si_pid != 0 && !ending_)
    throw Failure("the daemon has ended by itself, status " + std::to_string(end.si_status));
}

std::string Traffic::reason_of_close(const Peer& peer) {
  if (!peer.close_reason().empty()) return peer.close_reason();
  if (ending_) return "the end of the daemon";
  if (peer.is_half_closed() && peer.pending() == 0) return "half close";
  const std::string is_cut = "does not read; disconnected";
  if (peer.number() && log_.has_line("connection " + std::to_string(*peer.number()) + " (", is_cut))
    return "does not read";
  const std::string from = peer.address().empty() ? "unix" : peer.address();
  if (!peer.has_received() && log_.has_line("client from " + from, "rejected"))
    return "too many clients";
  return {};
}

void Traffic::on_close(Peer& peer) {
  const std::string report = peer.text();
  std::string reason = reason_of_close(peer);
  // The log line is written at about the same time.
  for (int pings = 0; reason.empty() && pings < kMaxPings / 60; ++pings) {
    check_alive();
    control_.call("ping");
    reason = reason_of_close(peer);
  }
  if (reason.empty())
    throw Failure("the daemon has closed a connection without a reason: " + report);
  ++summary_.closed[reason];
}

void Traffic::on_response(Peer&, const CompletedRequest& completed) {
  ++summary_.responses[completed.error];
  if (!completed.result || !completed.method) return;
  const std::string_view method = protocol::name(*completed.method);
  const protocol::Json* effect = completed.result->find("effect");
  if (effect == nullptr || !method.starts_with("effect.")) return;
  const auto number = static_cast<std::uint32_t>(*effect->as<std::int64_t>());
  effects_.admitted(number);
  generator_.add_effect(number);
}

void Traffic::on_notification(Peer& peer, const protocol::Json& message) {
  ++summary_.notifications;
  if (&peer == &watcher_) effects_.event(*message.find("params"));
}

e2e::Json Traffic::call(const std::string& method, const e2e::Json& params) {
  ++summary_.requests;
  const e2e::Json reply = control_.call(method, params);
  ++summary_.responses[reply.contains("code") ? reply["code"].get<int>() : 0];
  return reply;
}

void Traffic::reload(const std::string& configuration, bool is_good, double current_a) {
  const std::string report = is_good ? "configuration reloaded" : "the old one remains in effect";
  const std::string rejected = "the new limits were not applied";
  const std::size_t before = log_.count(report);
  const std::size_t rejections = log_.count(rejected);
  home_.configure(configuration);
  daemon_.signal(SIGHUP);
  ++summary_.reloads;
  pump_until([&] { return log_.count(report) > before; },
             [&] { return "\"" + report + "\" in the log for " + configuration; });
  // Wider limits take effect at the next start.
  if (is_good && log_.count(rejected) == rejections) current_a_ = std::min(current_a_, current_a);
}

std::string Traffic::text() const {
  std::string text;
  for_each_peer([&](const Peer& peer) {
    if (peer.pending() > 0 || peer.unsent_bytes() > 0 || peer.is_half_closed())
      text += peer.text() + "\n";
  });
  return text;
}

}  // namespace hedgehog::soak
