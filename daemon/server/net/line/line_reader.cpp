// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/line_reader.h"

namespace hedgehog::server {

void LineReader::feed(std::string_view bytes) {
  buffer_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  if (!first_byte_) {
    const std::size_t at = bytes.find_first_not_of("\r\n");
    if (at != std::string_view::npos) first_byte_ = bytes[at];
  }
  buffer_.append(bytes);
}

std::optional<LineReader::Line> LineReader::next() {
  for (;;) {
    const std::size_t end = buffer_.find('\n', scanned_);
    const bool whole = end != std::string::npos;
    scanned_ = whole ? end : buffer_.size();
    std::string_view text(buffer_.data() + begin_, scanned_ - begin_);
    if (whole && text.ends_with('\r')) text.remove_suffix(1);
    // One byte more while the line is incomplete: it may be the CR of a CRLF.
    const bool too_long = text.size() > limit_ + (whole ? 0 : 1);
    const bool was_skipping = skipping_;
    if (whole) {
      begin_ = scanned_ = end + 1;
      skipping_ = false;
    } else if (too_long || was_skipping) {
      begin_ = scanned_ = buffer_.size();
      skipping_ = true;
    }
    if (too_long && !was_skipping) return Line{{}, true};
    if (!whole) return std::nullopt;
    if (!was_skipping) return Line{text, false};
  }
}

}  // namespace hedgehog::server
