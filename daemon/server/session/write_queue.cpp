// SPDX-License-Identifier: MIT
#include "daemon/server/session/write_queue.h"

#include <utility>

namespace hedgehog::server {

bool WriteQueue::push(std::string line, LineKind kind) {
  line.push_back('\n');
  if (kind == LineKind::kTelemetry && bytes_ + line.size() > max_bytes_ / 2) {
    ++dropped_;
    return true;
  }
  if (bytes_ + line.size() > max_bytes_) drop_telemetry();
  if (bytes_ + line.size() > max_bytes_) return false;
  bytes_ += line.size();
  lines_.push_back({std::move(line), kind});
  return true;
}

const std::string& WriteQueue::take_one() {
  sending_ = std::move(lines_.front().text);
  lines_.pop_front();
  return sending_;
}

const std::string& WriteQueue::take() {
  take_one();
  while (!lines_.empty() && sending_.size() + lines_.front().text.size() <= kChunkBytes) {
    sending_ += lines_.front().text;
    lines_.pop_front();
  }
  return sending_;
}

void WriteQueue::sent() noexcept {
  bytes_ -= sending_.size();
  sending_.clear();
}

void WriteQueue::drop_telemetry() {
  dropped_ += std::erase_if(
      lines_,
      [this](const Line& line) {
        const bool telemetry = line.kind == LineKind::kTelemetry;
        bytes_ -= telemetry ? line.text.size() : 0;
        return telemetry;
      });
}

}  // namespace hedgehog::server
