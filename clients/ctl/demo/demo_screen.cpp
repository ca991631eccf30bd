// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/demo_screen.h"

#include <algorithm>
#include <optional>

#include "clients/ctl/screen/ball_map.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

constexpr std::size_t kScreenColumns = 79;

/// `begin` at the left edge and `end` at the right one.
std::string spread(const std::string& begin, const std::string& end) {
  const std::size_t taken = columns(begin) + columns(end);
  return begin + std::string(taken < kScreenColumns ? kScreenColumns - taken : 1, ' ') + end;
}

std::string title_line(const Ball& ball, const TourChapter& chapter, bool ascii) {
  const std::string count = chapter.number == 0 ? ""
                                                : std::to_string(chapter.number) + "/" +
                                                      std::to_string(kTourChapters) + "   ";
  return spread(std::string(ascii ? " Hedgehog - " : " Hedgehog · ") + chapter.title,
                count + (ball.status.simulated ? "simulated" : ball.status.device));
}

std::string request_line(const protocol::Status& status, const TourStep* playing) {
  if (playing == nullptr) return "";
  return "   " + left(playing->method, 15) + playing->params +
         (status.derating ? R"(   limited_by: "thermal")" : "");
}

/// The caption of a pulse includes its side.
std::string caption_line(const TourChapter& chapter, const TourStep* playing) {
  const bool pulse = playing != nullptr && playing->method == "effect.pulse";
  return "   " + chapter.caption + (pulse ? "  " + playing->words.substr(6) : "");
}

}  // namespace

std::vector<std::string> demo_screen(const Ball& ball, const TourChapter& chapter,
                                     const TourStep* playing, const ScreenStyle& style) {
  const protocol::Status& status = ball.status;
  std::optional<model::Vec3> up;
  if (chapter.number == 4 && status.orientation) up = status.orientation->up;
  std::vector<std::string> lines{title_line(ball, chapter, style.ascii), ""};
  for (std::string& line : ball_map(pin_array(ball.description), status.pins.force_n,
                                    {.ascii = style.ascii, .world_up = up}))
    lines.push_back(std::move(line));
  lines.emplace_back();
  lines.push_back(caption_line(chapter, playing));
  lines.push_back(cut(request_line(status, playing), kScreenColumns));
  lines.emplace_back();
  lines.push_back(temperature_line(ball, thresholds_words(ball), style.ascii));
  lines.push_back(windings_line(status, style.ascii));
  lines.push_back(thermistor_line(ball, style.ascii));
  lines.push_back(current_line(ball, allowed_words(ball), style.ascii));
  lines.emplace_back();
  lines.push_back(spread("   " + ball_map_legend(style.ascii), "Ctrl-C: coils off, end"));
  return lines;
}

}  // namespace hedgehog::client
