// SPDX-License-Identifier: MIT
// Plays the tour on a daemon, by device time, and shows it: as a picture on a terminal, otherwise a
// line per step or event.
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

/// One thread. Ends early when interrupted; the effects are then ended by `stop_all`.
class TourPlayer {
 public:
  TourPlayer(Connection& connection, Ball ball, const ScreenStyle& style);

  Outcome<void> play();

  const model::Limits& limits() const noexcept { return ball_.description.limits; }
  const TourRecord& record() const noexcept { return record_; }
  /// Start, device time.
  std::int64_t began_ns() const noexcept { return start_ns_; }
  /// Duration, device time.
  double seconds() const noexcept { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;

  Outcome<void> subscribe();
  Outcome<void> play_chapter(const TourChapter& chapter);
  /// Until `at` after the start: processes notifications and draws.
  Outcome<void> wait_until(Milliseconds at, const TourChapter& chapter);
  /// Processes the notifications received so far.
  Outcome<void> drain_messages(const TourChapter& chapter);
  /// Delays the rest of the tour if `at` was missed by more than `kMaxLate`: lost time is not
  /// caught up.
  Outcome<void> keep_distance(Milliseconds at, const TourChapter& chapter);
  void take(const Notification& notification, const TourChapter& chapter);
  Outcome<void> send(const TourStep& step);
  void draw(const TourChapter& chapter);
  /// Output for a pipe. `print_played`: the line of the step that has none yet, with the values
  /// reached so far.
  void print_played();
  void print_derating(const protocol::Event& event);
  void print_rest(const TourChapter& chapter);
  /// Time of the tour by device time: the last one reported plus the time since, without the time
  /// lost.
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
