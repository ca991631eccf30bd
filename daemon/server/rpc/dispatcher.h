// SPDX-License-Identifier: MIT
// Requests to responses: decodes a line, carries out its requests in order, hands the commands of
// the whole line over together, and responds at once or when the ticks have come that the response
// needs.
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
  /// The control thread has this long to make an answer possible, as `PolledTime` counts it.
  static constexpr std::chrono::seconds kPatience{2};

  explicit Dispatcher(HandlerContext& context) : context_(context) {}

  /// One line of `session`, without its LF.
  void line(Session& session, std::string_view text);
  void line_too_long(Session& session);
  /// Whether one of the requests of `line` is an emergency stop.
  static bool has_emergency_stop(std::string_view line);

  /// Forecasts of one batch, lists of patterns, histories; the others are answered `busy`. A batch
  /// cannot be interrupted, and whoever wants to stop the ball waits behind it.
  static constexpr int kMaxCostly = 8;
  /// What an answer that is still to come counts as; most are shorter.
  static constexpr std::size_t kReservedBytes = 1024;

  /// After every new snapshot.
  void poll();
  bool waiting() const noexcept { return !waiting_.empty(); }
  /// Answers to `session` are still to come.
  bool has_pending(ConnectionId session) const noexcept { return pending(session) > 0; }
  /// So many.
  std::size_t pending(ConnectionId session) const noexcept;

 private:
  /// The answers to one line, until all are there.
  struct Reply {
    ConnectionId session = 0;
    bool batch = false;
    std::vector<std::string> answers;
    /// Of the answers, and `kReservedBytes` for each that is open.
    std::size_t bytes = 0;
    int open = 0;
    std::map<protocol::Method, int> costly;

    void add(std::string answer);
    /// An answer to come; its index.
    std::size_t reserve();
    void fill(std::size_t index, std::string answer);
    std::size_t open_bytes() const noexcept { return open > 0 ? bytes : 0; }
  };
  struct Waiting {
    std::shared_ptr<Reply> reply;
    std::size_t index = 0;
    protocol::Id id;
    std::string_view method;
    Deferred deferred;
    PolledTime waited;
  };

  void item(Session& session, protocol::Item& item, const std::shared_ptr<Reply>& reply);
  void send_if_complete(const Reply& reply);

  HandlerContext& context_;
  std::vector<Waiting> waiting_;
};

}  // namespace hedgehog::server
