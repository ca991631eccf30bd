// SPDX-License-Identifier: MIT
#include "clients/lib/threaded_ball.h"

namespace hedgehog {

ThreadedBall::ThreadedBall(std::vector<client::Address> addresses, BallOptions options)
    : ball_(std::move(addresses), std::move(options)), thread_([this] { run(); }) {}

ThreadedBall::~ThreadedBall() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool ThreadedBall::connected() const {
  const std::lock_guard lock(mutex_);
  return connected_;
}

int ThreadedBall::connections() const {
  const std::lock_guard lock(mutex_);
  return connections_;
}

std::string ThreadedBall::problem() const {
  const auto why = failure();
  return why ? why->message : std::string();
}

std::optional<client::ClientError> ThreadedBall::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

bool ThreadedBall::rumble(std::string_view slot, double strength,
                          std::optional<protocol::Direction> direction,
                          protocol::EffectParams others) {
  if (!connected()) return false;
  return post(
      [slot = std::string(slot), strength, direction = direction,
       others = std::move(others)](Ball& ball) { ball.rumble(slot, strength, direction, others); });
}

bool ThreadedBall::notify(protocol::Request request) {
  if (!connected()) return false;
  return post([request = std::move(request)](Ball& ball) { ball.notify(request); });
}

bool ThreadedBall::notify_raw(std::string method, std::string params_json) {
  if (!connected()) return false;
  return post([method = std::move(method), params = std::move(params_json)](Ball& ball) {
    ball.notify_raw(method, params);
  });
}

std::future<client::Outcome<std::string>> ThreadedBall::call_raw(std::string method,
                                                                 std::string params_json) {
  return later<std::string>([method = std::move(method), params = std::move(params_json)](
                                Ball& ball) { return ball.call_raw(method, params); });
}

std::optional<client::Notification> ThreadedBall::next() {
  const std::lock_guard lock(mutex_);
  if (notifications_.empty()) return std::nullopt;
  std::optional<client::Notification> oldest = std::move(notifications_.front());
  notifications_.pop_front();
  return oldest;
}

std::optional<client::ClientError> ThreadedBall::refused_renewal() {
  const std::lock_guard lock(mutex_);
  if (refused_renewals_.empty()) return std::nullopt;
  std::optional<client::ClientError> oldest = std::move(refused_renewals_.front());
  refused_renewals_.pop_front();
  return oldest;
}

bool ThreadedBall::post(Task task) {
  {
    const std::lock_guard lock(mutex_);
    if (tasks_.size() >= kMaxQueued) return false;
    tasks_.push_back(std::move(task));
  }
  changed_.notify_one();
  return true;
}

void ThreadedBall::run() {
  std::unique_lock lock(mutex_);
  for (bool ending = false; !ending;) {
    std::deque<Task> tasks;
    tasks.swap(tasks_);
    ending = ending_;
    lock.unlock();
    for (const Task& task : tasks) task(ball_);
    ball_.update();
    lock.lock();
    connected_ = ball_.connected();
    connections_ = ball_.connections();
    failure_.reset();
    if (!ball_.problem().empty()) failure_ = ball_.failure();
    while (auto notification = ball_.next()) {
      if (notifications_.size() >= Ball::kMaxUnread) notifications_.pop_front();
      notifications_.push_back(*std::move(notification));
    }
    while (auto refused = ball_.refused_renewal()) {
      if (refused_renewals_.size() >= Ball::kMaxRefused) refused_renewals_.pop_front();
      refused_renewals_.push_back(*std::move(refused));
    }
    if (!ending)
      changed_.wait_for(lock, kReadInterval, [this] { return ending_ || !tasks_.empty(); });
  }
}

}  // namespace hedgehog
