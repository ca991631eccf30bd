// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/tour_player.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "clients/common/interrupts.h"
#include "clients/ctl/demo/demo_screen.h"
#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/terminal/words.h"
#include "clients/ctl/verbs/session.h"

namespace hedgehog::client {

namespace {

constexpr double kPictureHz = 25.0;
constexpr Milliseconds kPicturePeriod{40};
constexpr std::size_t kPinsShown = 4;
/// Shorter than the pause between two effects of the tour, 100 ms, so that they never overlap.
constexpr Milliseconds kMaxLate{50};
/// A machine may be busy for this long; after a longer silence the ball is considered lost.
constexpr Milliseconds kMinTimeout{10'000};

Milliseconds timeout() { return std::max(kMinTimeout, response_timeout()); }

}  // namespace

TourPlayer::TourPlayer(Connection& connection, Ball ball, const ScreenStyle& style)
    : connection_(connection),
      ball_(std::move(ball)),
      style_(style),
      picture_(terminal_traits().picture),
      chapters_(tour(ball_.status.simulated)) {}

Outcome<void> TourPlayer::play() {
  if (auto subscribed = subscribe(); !subscribed) return subscribed.error();
  if (picture_) terminal_ = std::make_unique<Terminal>();
  start_ns_ = ball_.status.time_ns;
  received_at_ = Clock::now();
  Outcome<void> outcome;
  for (const TourChapter& chapter : chapters_) {
    outcome = play_chapter(chapter);
    if (!outcome || interrupted()) break;
  }
  seconds_ = now_s() + std::chrono::duration<double>(lost_).count();
  terminal_.reset();
  if (interrupted()) {
    const auto stopped = connection_.call(protocol::EffectStopAll{});
    return stopped ? Outcome<void>() : Outcome<void>(stopped.error());
  }
  return outcome;
}

Outcome<void> TourPlayer::subscribe() {
  const auto telemetry =
      connection_.call(protocol::TelemetrySubscribe{kPictureHz, protocol::kEveryStatusKey});
  if (!telemetry) return telemetry.error();
  const auto events = connection_.call(protocol::EventsSubscribe{});
  return events ? Outcome<void>() : Outcome<void>(events.error());
}

Outcome<void> TourPlayer::play_chapter(const TourChapter& chapter) {
  playing_ = nullptr;
  for (const TourStep& step : chapter.steps) {
    if (auto waited = wait_until(step.at, chapter); !waited || interrupted()) return waited;
    if (step.shown) {
      print_played();
      pending_step_ = playing_ = &step;
      record_.take_pins();
      record_.take_current_a();
      record_.take_max_felt();
    }
    if (auto sent = send(step); !sent) return sent;
    if (auto kept = keep_distance(step.at, chapter); !kept) return kept;
  }
  auto waited = wait_until(chapter.to, chapter);
  print_played();
  if (&chapter == &chapters_.back()) print_rest(chapter);
  return waited;
}

Outcome<void> TourPlayer::wait_until(Milliseconds at, const TourChapter& chapter) {
  auto received = drain_messages(chapter);
  while (received && !interrupted() && now() < at) {
    auto notification = connection_.next(std::min(at - now(), kPicturePeriod));
    if (!notification) return notification.error();
    if (*notification) {
      take(**notification, chapter);
      received = drain_messages(chapter);
    } else if (Clock::now() - received_at_ > timeout()) {
      const auto seconds = std::chrono::duration<double>(timeout()).count();
      return ClientError{
          Failure::kTimeout, "the ball has sent nothing for " + fixed(seconds, 0) + " s", {}};
    }
  }
  return received ? keep_distance(at, chapter) : received;
}

Outcome<void> TourPlayer::drain_messages(const TourChapter& chapter) {
  for (;;) {
    auto notification = connection_.next(Milliseconds{0});
    if (!notification) return notification.error();
    if (!*notification) return {};
    take(**notification, chapter);
  }
}

Outcome<void> TourPlayer::keep_distance(Milliseconds at, const TourChapter& chapter) {
  auto received = drain_messages(chapter);
  if (const Milliseconds late = now() - at; late > kMaxLate) lost_ += late;
  return received;
}

void TourPlayer::take(const Notification& notification, const TourChapter& chapter) {
  if (const auto* event = std::get_if<protocol::EventMessage>(&notification)) {
    record_.take(event->event);
    print_derating(event->event);
    return;
  }
  ball_.status = std::get<protocol::TelemetryMessage>(notification).telemetry.status;
  received_at_ = Clock::now();
  record_.take(ball_.status);
  draw(chapter);
}

Outcome<void> TourPlayer::send(const TourStep& step) {
  const auto response = connection_.call_raw(step.method, step.params, timeout());
  if (response) return {};
  if (response.error().failure != Failure::kRefused) return response.error();
  record_.refused(step.method + ": " + response.error().message);
  return {};
}

void TourPlayer::draw(const TourChapter& chapter) {
  if (terminal_ != nullptr) terminal_->draw(demo_screen(ball_, chapter, playing_, style_));
}

void TourPlayer::print_played() {
  if (pending_step_ == nullptr) return;
  const TourStep& step = *std::exchange(pending_step_, nullptr);
  const std::optional<double> current_a = record_.take_current_a();
  const std::vector<std::int64_t> pins = record_.take_pins();
  if (picture_ || !current_a) return;
  std::string felt = std::to_string(record_.take_max_felt()) + " pins felt";
  if (step.method == "effect.circle") {
    felt = "pins";
    for (std::size_t i = 0; i < std::min(pins.size(), kPinsShown); ++i)
      felt += " " + std::to_string(pins[i]);
    felt += " … (" + std::to_string(pins.size()) + " passed)";
  }
  std::printf("%5.1f s  %s %s A   %s   %s\n", static_cast<double>(step.at.count()) / 1000.0,
              left(step.words, 17).c_str(), right(fixed(*current_a, 1), 5).c_str(), felt.c_str(),
              temperature_words(ball_.status.temperature_c.model).c_str());
  std::fflush(stdout);
}

void TourPlayer::print_derating(const protocol::Event& event) {
  if (picture_ || event.type != "derating_started") return;
  print_played();
  std::printf("%5.1f s  %s %s A allowed   %s\n", now_s(), left("derating", 17).c_str(),
              right(fixed(event.limit_a.value_or(0.0), 1), 5).c_str(),
              temperature_words(event.temperature_c).c_str());
  std::fflush(stdout);
}

void TourPlayer::print_rest(const TourChapter& chapter) {
  if (picture_) return;
  const protocol::Status& status = ball_.status;
  std::printf("%5.1f s  %s %s A allowed   %s\n", static_cast<double>(chapter.to.count()) / 1000.0,
              left(chapter.title, 17).c_str(), right(fixed(status.limit_a, 1), 5).c_str(),
              temperature_words(status.temperature_c.model).c_str());
  std::fflush(stdout);
}

Milliseconds TourPlayer::now() const {
  // Limited extrapolation: the device time of a slow or paused ball advances no further than
  // reported.
  const auto since = std::chrono::floor<Milliseconds>(Clock::now() - received_at_);
  const std::chrono::nanoseconds reported(ball_.status.time_ns - start_ns_);
  return std::chrono::floor<Milliseconds>(reported) + std::min(since, kPicturePeriod) - lost_;
}

double TourPlayer::now_s() const { return static_cast<double>(now().count()) / 1000.0; }

}  // namespace hedgehog::client
