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

using client::Outcome;

constexpr double kTelemetryHz = 100.0;
// A game's upload is blocked meanwhile; the daemon is on this machine.
constexpr Milliseconds kConnectTimeout{200};
constexpr Milliseconds kHelloTimeout{500};
constexpr Milliseconds kSendTimeout{200};
constexpr Milliseconds kMaxWait{500};
// Same age limit as of the daemon's world-frame effects.
constexpr std::int64_t kStaleMs = 100;

}  // namespace

Bridge::Bridge(GamepadDevice& device, const BridgeOptions& options, Report report)
    : device_(device),
      options_(options),
      report_(std::move(report)),
      player_(options.translation),
      axes_(options.tilt) {}

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
  if (!connection_) until = std::min(until, next_attempt_);
  const auto left = std::max(Milliseconds(0), std::chrono::ceil<Milliseconds>(until - now));
  std::array<pollfd, 2> waiting{{{device_.descriptor(), POLLIN, 0}, {-1, POLLIN, 0}}};
  if (connection_) waiting[1].fd = connection_->descriptor();
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
  Outcome<void> done{};
  if (connection_) {
    done = exchange();
  } else {
    (void)player_.take_requests();  // discarded while not connected
    if (now >= next_attempt_) done = connect();
  }
  if (done) return {};
  const bool was_connected = connection_.has_value();
  connection_.reset();
  move_stick({});
  next_attempt_ = client::Clock::now() + backoff_.next();
  if (options_.once) return Problem(kUnavailable, done.error().message);
  report_once(done.error().message + (was_connected ? "; reconnecting" : "; waiting for it"));
  return {};
}

Outcome<void> Bridge::connect() {
  auto opened = client::Connection::open(options_.addresses, kConnectTimeout);
  if (!opened) return opened.error();
  const auto hello = opened->hello("hedgehog-gamepad/" HEDGEHOG_VERSION, {}, kHelloTimeout);
  if (!hello) return hello.error();
  protocol::StatusKeys keys;
  keys.add(protocol::StatusKey::kOrientation);
  const auto telemetry =
      opened->call(protocol::TelemetrySubscribe{kTelemetryHz, keys}, kHelloTimeout);
  if (!telemetry) return telemetry.error();
  connection_.emplace(*std::move(opened));
  backoff_.reset();
  const auto& limits = hello->limits;
  player_.on_connect(limits.current_a > 0.0 ? limits.felt_a / limits.current_a : 0.0);
  report_once("connected to " + client::to_string(connection_->address()) + ", the ball is " +
              hello->state + (hello->remedy ? ": " + *hello->remedy : ""));
  return {};
}

Outcome<void> Bridge::exchange() {
  for (const protocol::Request& request : player_.take_requests())
    if (auto sent = connection_->request(request, kSendTimeout); !sent) return sent.error();
  for (;;) {
    auto notification = connection_->next(Milliseconds(0));
    if (!notification) return notification.error();
    while (const auto response = connection_->response()) {
      // An effect may have ended just before its renewal or stop arrived.
      if (!response->result && response->result.error().code != protocol::ErrorCode::kNoSuchEffect)
        report_once("the daemon refuses an effect: " + response->result.error().message);
    }
    if (!*notification) return {};
    take(**notification);
  }
}

void Bridge::take(const client::Notification& notification) {
  const auto* message = std::get_if<protocol::TelemetryMessage>(&notification);
  if (message == nullptr) return;
  const auto& orientation = message->telemetry.status.orientation;
  const bool known = orientation && orientation->age_ms <= kStaleMs;
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
