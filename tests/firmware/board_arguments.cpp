// SPDX-License-Identifier: MIT
#include "tests/firmware/board_arguments.h"

#include <charconv>
#include <cstring>
#include <string_view>

#include "daemon/device/simulator/plant_text.h"

namespace hedgehog::device {
namespace {

template <class Number>
bool parse(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  const auto result = std::from_chars(text, end, number);
  return result.ec == std::errc{} && result.ptr == end;
}

bool read_plant(const char* value, SimulatedBoardOptions& board) {
  const std::optional<model::PlantParameters> plant = plant_from(value);
  if (!plant) return false;
  const std::uint64_t seed = board.plant.seed;
  board.plant = *plant;
  board.plant.seed = seed;
  return true;
}

bool read_front_end(const char* value, FrontEndChoice& front_end) {
  const auto kind = front_end_kind(value);
  if (kind) front_end.kind = *kind;
  return kind.has_value();
}

bool read_thermistors(const char* value, FrontEndChoice& front_end) {
  const int count = parse(value, front_end.thermistors) ? front_end.thermistors : -1;
  return count == 0 || count == 1 || count == 3;
}

bool read_value(std::string_view name, const char* value, BoardArguments& arguments) {
  SimulatedBoardOptions& board = arguments.board;
  if (name == "--fd") return parse(value, arguments.fd);
  if (name == "--ambient") return parse(value, board.ambient_c);
  if (name == "--start-temperature") return parse(value, board.start_c);
  if (name == "--seed") return parse(value, board.plant.seed);
  if (name == "--front-end") return read_front_end(value, board.front_end);
  if (name == "--thermistors") return read_thermistors(value, board.front_end);
  if (name == "--parts") return parse(value, board.front_end.seed);
  if (name == "--plant") return read_plant(value, board);
  return name == "--trace";
}

}  // namespace

std::optional<BoardArguments> read_board_arguments(std::span<const char* const> words) {
  BoardArguments arguments;
  arguments.board.plant.seed = 1;
  bool start_given = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view name = words[i];
    if (name == "--in-step") continue;
    if (++i == words.size() || !read_value(name, words[i], arguments)) return std::nullopt;
    start_given |= name == "--start-temperature";
  }
  if (!start_given) arguments.board.start_c = arguments.board.ambient_c;
  return arguments;
}

}  // namespace hedgehog::device
