// SPDX-License-Identifier: MIT
// A gamepad device whose game is a test.
#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "clients/gamepad/gamepad_device.h"

namespace hedgehog::gamepad {

/// The device is on the bridge's thread; everything else may be called on any thread.
class FakeGamepad : public GamepadDevice {
 public:
  ~FakeGamepad() override { ::close(fd_); }

  void command(const DeviceCommand& command) {
    const std::lock_guard lock(mutex_);
    commands_.push_back(command);
    ::eventfd_write(fd_, 1);
  }
  /// The errno of the latest response to an upload; -1: none yet.
  int uploaded() const { return uploaded_; }
  int erased() const { return erased_; }
  bool moved() const { return moved_; }
  StickPosition stick() const {
    const std::lock_guard lock(mutex_);
    return stick_;
  }

  /// The oldest move of the stick that was not returned yet; nullopt after a minute without one.
  std::optional<StickPosition> next_move() {
    std::unique_lock lock(mutex_);
    if (!has_moved_.wait_for(lock, std::chrono::minutes(1), [&] { return !moves_.empty(); }))
      return std::nullopt;
    const StickPosition oldest = moves_.front();
    moves_.pop_front();
    return oldest;
  }
  /// `done` runs on the bridge's thread after each response to an upload. REQUIRES: before the
  /// bridge runs.
  void on_upload(std::function<void()> done) { on_upload_ = std::move(done); }

  int descriptor() const noexcept override { return fd_; }
  Result<std::optional<DeviceCommand>> next() override {
    const std::lock_guard lock(mutex_);
    eventfd_t ignored = 0;
    ::eventfd_read(fd_, &ignored);
    if (commands_.empty()) return std::optional<DeviceCommand>();
    std::optional<DeviceCommand> oldest = commands_.front();
    commands_.pop_front();
    return oldest;
  }
  void answer_upload(const UploadRequest&, int error) override {
    uploaded_ = error;
    if (on_upload_) on_upload_();
  }
  void answer_erase(const EraseRequest&, int error) override { erased_ = error; }
  void move_stick(const StickPosition& position) override {
    const std::lock_guard lock(mutex_);
    stick_ = position;
    moved_ = true;
    moves_.push_back(position);
    has_moved_.notify_all();
  }

 private:
  int fd_ = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  mutable std::mutex mutex_;
  std::deque<DeviceCommand> commands_;
  StickPosition stick_{};
  std::deque<StickPosition> moves_;
  std::condition_variable has_moved_;
  std::function<void()> on_upload_;
  std::atomic<int> uploaded_ = -1;
  std::atomic<int> erased_ = -1;
  std::atomic<bool> moved_ = false;
};

}  // namespace hedgehog::gamepad
