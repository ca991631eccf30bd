// SPDX-License-Identifier: MIT
// Plays the tour on a daemon, by the ball's clock, and shows it: as a picture on a terminal, else a
// line a happening.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "clients/common/terminal.h"
#include "clients/ctl/demo/tour.h"
#include "clients/ctl/demo/tour_record.h"
#include "clients/ctl/screen/ball.h"
#include "clients/ctl/screen/status_screen.h"
#include "clients/lib/connection.h"

namespace hedgehog::client {

/// One thread. Ends early when the person interrupts; the effects then end with `stop_all`.
class TourPlayer {
 public:
  TourPlayer(Connection& connection, Ball ball, const ScreenStyle& style);

  Outcome<void> play();

  const protocol::LimitsDescription& limits() const noexcept { return ball_.description.limits; }
  const TourRecord& record() const noexcept { return record_; }
  /// When it began, by the ball's clock.
  std::int64_t began_ns() const noexcept { return start_ns_; }
  /// How long it took, of the ball's time.
  double seconds() const noexcept { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;

  Outcome<void> subscribe();
  Outcome<void> play_chapter(const TourChapter& chapter);
  /// Until `at` after the start: takes what the daemon says, and draws.
  Outcome<void> wait_until(Milliseconds at, const TourChapter& chapter);
  /// Takes what has come already.
  Outcome<void> take_waiting(const TourChapter& chapter);
  /// Delays the rest of the tour when `at` was missed by much: time lost stays lost.
  Outcome<void> keep_distance(Milliseconds at, const TourChapter& chapter);
  void take(const Notification& notification, const TourChapter& chapter);
  Outcome<void> send(const TourStep& step);
  void draw(const TourChapter& chapter);
  /// Lines for a pipe: the step that has just been played, or a derating.
  /// The line of the step that has not got one yet, with what it reached so far.
  void print_played();
  void print_derating(const protocol::Event& event);
  void print_rest(const TourChapter& chapter);
  /// Time of the tour by the ball's clock: what it told last, and what has passed since, without
  /// what was lost.
  Milliseconds now() const;
  double now_s() const;

  Connection& connection_;
  Ball ball_;
  ScreenStyle style_;
  bool picture_;
  std::vector<TourChapter> chapters_;
  std::unique_ptr<Terminal> terminal_;
  TourRecord record_;
  const TourStep* playing_ = nullptr;
  const TourStep* pending_step_ = nullptr;
  std::int64_t start_ns_ = 0;
  Milliseconds lost_{};
  Clock::time_point received_at_{};
  double seconds_ = 0.0;
};

}  // namespace hedgehog::client
