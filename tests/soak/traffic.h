// SPDX-License-Identifier: MIT
// The clients of one start of the daemon: each in a numbered place, plus one that receives all
// events and one that pings.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"
#include "tests/soak/effects_model.h"
#include "tests/soak/log_view.h"
#include "tests/soak/peer.h"
#include "tests/soak/random.h"
#include "tests/soak/request_generator.h"
#include "tests/soak/summary.h"

namespace hedgehog::soak {

class Traffic : public PeerObserver {
 public:
  static constexpr std::size_t kPlaces = 10;

  /// `current_a`: the current limit of the configuration.
  Traffic(e2e::DaemonProcess& daemon, const e2e::Home& home, RequestGenerator& generator,
          Summary& summary, double current_a);

  /// The client in that place; null: none, or its connection has ended.
  Peer* peer(std::size_t place);
  /// Connects a new client there, whose first request is a hello.
  Peer& connect(std::size_t place, Transport transport, int receive_buffer);

  /// Connects a client there whose first bytes are no request.
  void connect_foreign(std::size_t place, Transport transport, const std::string& bytes);

  /// Sends and counts.
  void send(Peer& peer, const std::string& message, int fragments = 1);

  /// Reads and writes without blocking; waits up to `timeout_ms` if no connection is ready. True:
  /// something was exchanged.
  bool pump(int timeout_ms = 0);
  /// Pumps until `done`. Throws Failure with `what` after so many responses to pings that the
  /// daemon cannot merely be slow.
  void pump_until(const std::function<bool()>& done, const std::function<std::string()>& what);

  /// Waits until nothing is pending, then checks all invariants: each response has arrived, and the
  /// connections and effects are those of the connected clients.
  void check();
  /// Sends a request from the client that pings; returns the result.
  e2e::Json call(const std::string& method, const e2e::Json& params = e2e::Json::object());
  /// Sends SIGHUP with this configuration; waits until the daemon has reported the outcome.
  /// `current_a`: the limit in it.
  void reload(const std::string& configuration, bool is_good, double current_a);
  /// The daemon is about to end: it may close every connection.
  void expect_end() noexcept { ending_ = true; }

  void on_response(Peer& peer, const CompletedRequest& completed) override;
  void on_notification(Peer& peer, const protocol::Json& message) override;

  LogView& log() noexcept { return log_; }
  /// For a report: the clients with anything pending.
  std::string text() const;

 private:
  std::string reason_of_close(const Peer& peer);
  void on_close(Peer& peer);
  void check_alive();
  void check_limits();
  void check_slot();
  void check_connections();
  void end_effects();
  bool is_settled() const;
  template <class Visit>
  void for_each_peer(Visit visit) const {
    for (const auto& peer : places_)
      if (peer) visit(*peer);
  }

  e2e::DaemonProcess& daemon_;
  const e2e::Home& home_;
  RequestGenerator& generator_;
  Summary& summary_;
  LogView log_;
  EffectsModel effects_;
  Endpoints endpoints_;
  std::array<std::unique_ptr<Peer>, kPlaces> places_;
  Peer watcher_;
  e2e::RawClient control_;
  double current_a_;
  bool ending_ = false;
};

}  // namespace hedgehog::soak
