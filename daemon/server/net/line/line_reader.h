// SPDX-License-Identifier: MIT
// Splits a byte stream into lines of at most 64 KiB. A longer line is reported once, as soon as it
// is too long, and its rest is skipped, so that memory stays bounded.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::server {

/// io thread; one per connection.
class LineReader {
 public:
  explicit LineReader(std::size_t limit) : limit_(limit) {}

  struct Line {
    std::string_view text;  // without LF or CRLF; valid until the next call; empty if too long
    bool too_long = false;
  };

  /// Appends `bytes`. REQUIRES: `next` has returned nullopt since the last `feed`.
  void feed(std::string_view bytes);
  /// The next complete line; nullopt: more bytes are needed.
  std::optional<Line> next();

  /// The first byte that is no line end; nullopt: none yet. Decides whether it is this protocol.
  std::optional<char> first_byte() const noexcept { return first_byte_; }

 private:
  std::size_t limit_;
  std::string buffer_;
  std::size_t begin_ = 0;    // of the incomplete line
  std::size_t scanned_ = 0;  // no LF before this position
  bool skipping_ = false;
  std::optional<char> first_byte_;
};

}  // namespace hedgehog::server
