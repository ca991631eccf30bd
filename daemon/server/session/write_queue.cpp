// SPDX-License-Identifier: MIT
#include "daemon/server/session/write_queue.h"

#include <utility>

namespace hedgehog::server {

bool WriteQueue::push(std::string line, LineKind kind) {
  line.push_back('\n');
  return push(Line{std::move(line), kind, nullptr});
}

bool WriteQueue::push(SharedLine line) {
  return push(Line{{}, LineKind::kTelemetry, std::move(line)});
}

bool WriteQueue::push(Line line) {
  const std::size_t size = line.bytes().size();
  if (line.kind == LineKind::kTelemetry && bytes_ + size > max_bytes_ / 2) {
    ++dropped_;
    return true;
  }
  if (bytes_ + size > max_bytes_) drop_telemetry();
  if (bytes_ + size > max_bytes_) return false;
  bytes_ += size;
  if (line.kind == LineKind::kResponse) response_bytes_ += size;
  lines_.push_back(std::move(line));
  return true;
}

void WriteQueue::move_next() {
  Line& line = lines_.front();
  if (line.kind == LineKind::kResponse) sending_responses_ += line.text.size();
  if (line.shared && lines_.size() == 1 && sending_.empty())
    sending_shared_ = std::move(line.shared);
  else
    sending_ += line.bytes();
  lines_.pop_front();
}

const std::string& WriteQueue::take_one() {
  move_next();
  return sending();
}

const std::string& WriteQueue::take() {
  take_one();
  while (!lines_.empty() && sending_.size() + lines_.front().bytes().size() <= kChunkBytes)
    move_next();
  return sending();
}

void WriteQueue::sent() noexcept {
  bytes_ -= sending().size();
  response_bytes_ -= sending_responses_;
  sending_.clear();
  sending_shared_.reset();
  sent_bytes_ = 0;
  sending_responses_ = 0;
}

void WriteQueue::drop_telemetry() {
  dropped_ += std::erase_if(
      lines_,
      [this](const Line& line) {
        const bool telemetry = line.kind == LineKind::kTelemetry;
        bytes_ -= telemetry ? line.bytes().size() : 0;
        return telemetry;
      });
}

}  // namespace hedgehog::server
