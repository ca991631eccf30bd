// SPDX-License-Identifier: MIT
// Unsent lines of one client. A client that reads too slowly loses telemetry first; if responses
// and events alone fill the queue, it has to be disconnected: those are never dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace hedgehog::server {

enum class LineKind : std::uint8_t { kResponse, kEvent, kTelemetry };

using SharedLine = std::shared_ptr<const std::string>;  // a line of telemetry with its LF

/// io thread; one per connection.
class WriteQueue {
 public:
  /// `max_bytes`: beyond it the client has stopped reading; beyond half, telemetry is dropped.
  explicit WriteQueue(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  static constexpr std::size_t kChunkBytes = 16 * 1024;  // small lines are sent together up to it

  /// Adds `line` and its LF. False: the queue is full, disconnect.
  [[nodiscard]] bool push(std::string line, LineKind kind);
  [[nodiscard]] bool push(SharedLine line);

  /// No lines are queued except those being sent.
  bool empty() const noexcept { return lines_.empty(); }
  /// The next lines as one buffer, valid until `sent`. REQUIRES: !empty(), !is_sending().
  const std::string& take();
  /// The same with the next line only.
  const std::string& take_one();
  bool is_sending() const noexcept { return sending_shared_ != nullptr || !sending_.empty(); }
  /// The taken lines, without the parts that were sent.
  std::string_view unsent() const noexcept {
    return std::string_view(sending()).substr(sent_bytes_);
  }
  /// `bytes` more of them were sent. REQUIRES: not more than `unsent`.
  void sent_part(std::size_t bytes) noexcept { sent_bytes_ += bytes; }
  void sent() noexcept;  // all of them

  /// Size of all lines, including the buffer being sent.
  std::size_t bytes() const noexcept { return bytes_; }
  std::size_t response_bytes() const noexcept { return response_bytes_; }  // among them
  std::uint64_t telemetry_dropped() const noexcept { return dropped_; }
  /// Number of lines dropped since the last call.
  std::uint64_t take_dropped() noexcept {
    return dropped_ - std::exchange(taken_dropped_, dropped_);
  }

 private:
  struct Line {
    std::string text;
    LineKind kind;
    SharedLine shared;  // instead of `text`
    const std::string& bytes() const noexcept { return shared ? *shared : text; }
  };
  bool push(Line line);
  void drop_telemetry();
  /// Moves the next line to the end of `sending_`, without a copy if it is a single shared one.
  void move_next();
  const std::string& sending() const noexcept {
    return sending_shared_ ? *sending_shared_ : sending_;
  }

  std::size_t max_bytes_;
  std::deque<Line> lines_;
  std::size_t bytes_ = 0;
  std::size_t response_bytes_ = 0;
  std::uint64_t dropped_ = 0;
  std::uint64_t taken_dropped_ = 0;
  std::string sending_;
  SharedLine sending_shared_;
  std::size_t sent_bytes_ = 0;
  std::size_t sending_responses_ = 0;  // bytes
};

}  // namespace hedgehog::server
