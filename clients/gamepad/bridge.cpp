// SPDX-License-Identifier: MIT
#include "clients/gamepad/bridge.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <variant>

#include "clients/gamepad/device_command_text.h"

namespace hedgehog::gamepad {

namespace {

constexpr double kTelemetryHz = 100.0;
constexpr Milliseconds kMaxWait{500};
// `Ball` has no descriptor while it connects.
constexpr Milliseconds kConnectInterval{10};
// Of an orientation, and of silence. Same age limit as of the daemon's world-frame effects.
constexpr std::int64_t kStaleMs = 100;
constexpr Milliseconds kPingInterval{500};

}  // namespace

Bridge::Bridge(GamepadDevice& device, const BridgeOptions& options, Report report)
    : device_(device),
      options_(options),
      report_(std::move(report)),
      player_(options.translation),
      axes_(options.tilt),
      ball_(options.addresses, {.name = "hedgehog-gamepad/" HEDGEHOG_VERSION}) {}

Result<void> Bridge::run(const std::function<bool()>& stop) {
  while (!stop())
    if (auto stepped = step(); !stepped) return stepped;
  return {};
}

Result<void> Bridge::step() {
  wait();
  const TimePoint now = client::Clock::now();
  if (auto handled = handle_device(now); !handled) return handled;
  player_.advance(now);
  return handle_daemon(now);
}

void Bridge::wait() const {
  const TimePoint now = client::Clock::now();
  TimePoint until = now + kMaxWait;
  if (const auto due = player_.deadline()) until = std::min(until, *due);
  until =
      std::min(until, ball_.connected() ? telemetry_due_
                                        : now + std::max(ball_.retry_after(), kConnectInterval));
  const auto left = std::max(Milliseconds(0), std::chrono::ceil<Milliseconds>(until - now));
  std::array<pollfd, 2> waiting{
      {{device_.descriptor(), POLLIN, 0}, {ball_.descriptor(), POLLIN, 0}}};
  (void)::poll(waiting.data(), waiting.size(), static_cast<int>(left.count()));
}

Result<void> Bridge::handle_device(TimePoint now) {
  for (;;) {
    const auto command = device_.next();
    if (!command) return command.error();
    if (!*command) return {};
    handle(**command, now);
  }
}

void Bridge::handle(const DeviceCommand& command, TimePoint now) {
  const int error = carry_out(command, now);
  if (!options_.trace) return;
  report_("game: " + to_text(command) +
          (error == 0 ? "" : std::string(": refused, ") + std::strerror(error)));
}

int Bridge::carry_out(const DeviceCommand& command, TimePoint now) {
  int error = 0;
  if (const auto* upload = std::get_if<UploadRequest>(&command)) {
    error = player_.upload(upload->effect, now);
    device_.answer_upload(*upload, error);
  } else if (const auto* erase = std::get_if<EraseRequest>(&command)) {
    error = player_.erase(erase->id, now);
    device_.answer_erase(*erase, error);
  } else if (const auto* play = std::get_if<PlayCommand>(&command)) {
    player_.play(play->id, play->count, now);
  } else if (const auto* gain = std::get_if<GainCommand>(&command)) {
    player_.set_gain(gain->gain);
  }
  return error;
}

Result<void> Bridge::handle_daemon(TimePoint now) {
  // Discarded while not connected.
  for (const protocol::Request& request : player_.take_requests()) (void)ball_.request(request);
  ball_.update();
  if (!ball_.connected()) return handle_problem();
  if (ball_.connections() != connections_) on_connect(now);
  while (const auto response = ball_.response()) take(*response);
  while (const auto notification = ball_.next()) take(*notification, now);
  if (now >= telemetry_due_) on_silence(now);
  return {};
}

Result<void> Bridge::handle_problem() {
  if (stick_) move_stick({});
  const std::string problem = ball_.problem();
  if (problem.empty()) return {};
  if (options_.once) return Problem(kUnavailable, problem);
  report_once(problem + (connections_ > 0 ? "; reconnecting" : "; waiting for it"));
  return {};
}

void Bridge::on_connect(TimePoint now) {
  connections_ = ball_.connections();
  telemetry_due_ = now + Milliseconds(kStaleMs);
  const protocol::HelloResult& hello = ball_.hello();
  const auto& limits = hello.limits;
  player_.on_connect(limits.current_a > 0.0 ? limits.felt_a / limits.current_a : 0.0);
  report_once("connected to " + client::to_string(ball_.address()) + ", the ball is " +
              hello.state + (hello.remedy ? ": " + *hello.remedy : ""));
  protocol::StatusKeys keys;
  keys.add(protocol::StatusKey::kOrientation);
  // On every connection: `Ball` renews a subscription only after its acceptance. Sending may end
  // the connection.
  subscription_ = ball_.request(protocol::TelemetrySubscribe{kTelemetryHz, keys});
}

void Bridge::on_silence(TimePoint now) {
  if (stick_) move_stick({});
  // `ball_` ends the connection if the response is overdue.
  (void)ball_.request(protocol::Ping{});
  telemetry_due_ = now + kPingInterval;
}

void Bridge::take(const protocol::Reply& response) {
  if (response.result) return;
  const protocol::RpcError& error = response.result.error();
  if (response.id == subscription_)
    report_once("the daemon refuses telemetry: " + error.message);
  else if (error.code != protocol::ErrorCode::kNoSuchEffect)
    // An effect may have ended just before its renewal or stop arrived.
    report_once("the daemon refuses an effect: " + error.message);
}

void Bridge::take(const client::Notification& notification, TimePoint now) {
  const auto* message = std::get_if<protocol::TelemetryMessage>(&notification);
  if (message == nullptr) return;
  telemetry_due_ = now + Milliseconds(kStaleMs);
  const auto& orientation = message->telemetry.status.orientation;
  const bool known = orientation && orientation->age_ms <= kStaleMs;
  if (known && !axes_.has_centre()) report_("the ball's present tilt is the centre of the stick");
  move_stick(known ? axes_.position(orientation->up) : StickPosition{});
}

void Bridge::move_stick(const StickPosition& position) {
  if (position == stick_) return;
  stick_ = position;
  device_.move_stick(position);
}

void Bridge::report_once(const std::string& message) {
  if (message == reported_) return;
  reported_ = message;
  report_(message);
}

}  // namespace hedgehog::gamepad
