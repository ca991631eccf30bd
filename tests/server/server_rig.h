// SPDX-License-Identifier: MIT
// The server with the real controller, link and simulated board, in lock-step and virtual time: no
// socket, no thread.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/control/loop/control_tick.h"
#include "daemon/device/simulator/lock_step.h"
#include "daemon/server/disk/pattern_library.h"
#include "daemon/server/history/event_history.h"
#include "daemon/server/rpc/server.h"

namespace hedgehog::server {

using Json = nlohmann::json;

class FakeStateStore final : public StateStore {
 public:
  void persist_gain(double value) override { gain = value; }
  std::uint64_t persist_latch(control::Reason reason) override {
    latch = reason;
    return ++writes;
  }
  Persisted latch_persisted(std::uint64_t) const override { return persisted; }
  double gain = -1.0;
  control::Reason latch = control::Reason::kNone;
  Persisted persisted = Persisted::kYes;
  std::uint64_t writes = 0;
};

/// Work of a disk that completes at once.
inline DiskWorkPtr done_work(const std::string& problem = {}) {
  auto work = std::make_shared<DiskWork>();
  work->problem = problem;
  work->done = true;
  return work;
}

class FakePatternStorage final : public PatternStorage {
 public:
  DiskWorkPtr keep(const std::string& name, std::string json) override {
    if (full) return nullptr;
    files[name] = std::move(json);
    return work();
  }
  DiskWorkPtr drop(const std::string& name) override {
    if (full) return nullptr;
    files.erase(name);
    return work();
  }
  std::map<std::string, std::string> files;
  std::string problem;
  bool full = false;

 private:
  DiskWorkPtr work() const { return done_work(problem); }
};

/// A client whose socket is a list of lines.
class FakeClient final : public Sink {
 public:
  explicit FakeClient(Server& its_server) : server(its_server) {}
  void send(std::string line, LineKind kind) override {
    unsent_bytes += line.size() + 1;
    lines.push_back({std::move(line), kind});
    if (!server.flush_after_pump(session, unsent_bytes)) flush(Flush::kSoon);
  }
  void flush(Flush when) override {
    ++flushes;
    urgent_flushes += when == Flush::kAtOnce;
    unsent_bytes = 0;
  }
  void finish() override { finished = true; }

  struct Line {
    std::string text;
    LineKind kind;
  };
  Server& server;
  std::deque<Line> lines;
  /// Number of writes to its socket, if it had one.
  int flushes = 0;
  /// Those among them that precede what takes long.
  int urgent_flushes = 0;
  std::size_t unsent_bytes = 0;
  Session session;
  bool finished = false;
};

class ServerRig {
 public:
  explicit ServerRig(config::Config settings = {}, const device::SimulatedBoardOptions& board = {});

  FakeClient& connect(protocol::Role role = protocol::Role::kOperate);
  void disconnect(FakeClient& client);

  /// Runs all components for `ticks` milliseconds; the server pumps after each.
  void run(model::Tick ticks);
  /// The same, but the server only reads the snapshots: events and responses are not processed.
  void run_without_pump(model::Tick ticks);
  /// Sends `method` with `params` and runs until the response arrives; returns its result, or its
  /// error.
  Json call(FakeClient& client, const std::string& method, const Json& params = Json::object());
  /// The same for a line of any kind; returns the whole response.
  Json exchange(FakeClient& client, const std::string& line);
  /// All lines of `kind` since the last call.
  std::vector<Json> on_event(FakeClient& client, LineKind kind = LineKind::kEvent);
  double plant_current_a() { return model::norm(world.board().plant().current_a()); }

  config::Config config;
  std::unique_ptr<control::Mailbox> mailbox = std::make_unique<control::Mailbox>();
  std::unique_ptr<device::LinkPort> port = std::make_unique<device::LinkPort>();
  FakeStateStore state_store;
  FakePatternStorage storage;
  PatternLibrary patterns{storage, {}};
  /// The content of the history's files.
  std::string history_lines;
  EventHistory history{[this](HistoryPart, const std::string& lines, bool) {
                         history_lines += lines;
                         return done_work();
                       },
                       {}};
  /// Time of day at the last tick.
  std::int64_t wall_ms() const { return 1'795'216'447'000 + tick_; }
  std::unique_ptr<control::ControlTick> control;
  device::LockStep world;
  std::unique_ptr<DeviceView> device_view;
  std::unique_ptr<Server> server;
  std::vector<control::Event> events;
  /// Called with each of them by the server's listener.
  std::function<void(const control::Event&)> on_listener_call;

 private:
  model::Tick tick_ = 0;
  int next_id_ = 0;
  std::deque<FakeClient> clients_;
};

}  // namespace hedgehog::server
