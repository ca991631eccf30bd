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
  if (kind == LineKind::kAnswer) answer_bytes_ += line.size();
  lines_.push_back({std::move(line), kind});
  return true;
}

void WriteQueue::move_next() {
  Line& line = lines_.front();
  if (line.kind == LineKind::kAnswer) sending_answers_ += line.text.size();
  if (sending_.empty())
    sending_ = std::move(line.text);
  else
    sending_ += line.text;
  lines_.pop_front();
}

const std::string& WriteQueue::take_one() {
  move_next();
  return sending_;
}

const std::string& WriteQueue::take() {
  take_one();
  while (!lines_.empty() && sending_.size() + lines_.front().text.size() <= kChunkBytes)
    move_next();
  return sending_;
}

void WriteQueue::sent() noexcept {
  bytes_ -= sending_.size();
  answer_bytes_ -= sending_answers_;
  sending_.clear();
  sending_answers_ = 0;
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
