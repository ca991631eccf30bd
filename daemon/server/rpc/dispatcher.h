// SPDX-License-Identifier: MIT
// Requests to responses: decodes a line, executes its requests in order, passes the commands of the
// whole line on together, and responds at once or after the ticks that the response depends on.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/rpc/handler_context.h"
#include "daemon/server/session/polled_time.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {

/// io thread only.
class Dispatcher {
 public:
  /// Maximum time for the control thread to complete a response, measured by `PolledTime`.
  static constexpr std::chrono::seconds kTimeout{2};

  explicit Dispatcher(HandlerContext& context) : context_(context) {}

  /// One line of `session`, without its LF.
  void line(Session& session, std::string_view text);
  void line_too_long(Session& session);
  /// True if one of the requests of `line` is an emergency stop.
  static bool has_emergency_stop(std::string_view line);

  /// Maximum number of forecasts, pattern lists and histories in one batch; further ones get
  /// `busy`. A batch cannot be interrupted, and delays an emergency stop.
  static constexpr int kMaxCostly = 8;
  static constexpr std::size_t kReservedBytes = 1024;  // assumed for a pending response

  void poll();  // after every new snapshot
  bool waiting() const noexcept { return !waiting_.empty(); }
  bool has_pending(ConnectionId session) const noexcept { return pending(session) > 0; }
  std::size_t pending(ConnectionId session) const noexcept;  // number of pending responses

 private:
  /// The responses to one line, until all are complete.
  struct Reply {
    ConnectionId session = 0;
    bool batch = false;
    std::vector<std::string> responses;
    std::size_t bytes = 0;  // of the responses, with kReservedBytes for each pending one
    int open = 0;
    std::map<protocol::Method, int> costly;

    void add(std::string response);
    /// Adds a pending response; returns its index.
    std::size_t reserve();
    void fill(std::size_t index, std::string response);
    std::size_t open_bytes() const noexcept { return open > 0 ? bytes : 0; }
  };
  struct Waiting {
    std::shared_ptr<Reply> reply;
    std::size_t index = 0;
    protocol::Id id;
    protocol::Method method{};
    Deferred deferred;
    PolledTime waited;
  };

  /// A response of the present line that is completed after its commit.
  struct Completion {
    std::size_t index = 0;
    protocol::Id id;
    protocol::Method method{};
    AfterCommit work;
  };

  void item(Session& session, protocol::Item& item, const std::shared_ptr<Reply>& reply);
  void complete(Reply& reply);
  void send_if_complete(Reply& reply);

  HandlerContext& context_;
  std::vector<Completion> completions_;
  std::vector<Waiting> waiting_;
};

}  // namespace hedgehog::server
