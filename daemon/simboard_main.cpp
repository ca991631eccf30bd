// SPDX-License-Identifier: MIT
// hedgehog-simboard: the simulated driver board as a process of its own, behind a socket that it
// inherits. It outlives its host until it has made itself safe.

#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include "daemon/device/simulator/plant_text.h"
#include "daemon/device/simulator/simulated_board_runner.h"
#include "daemon/device/socket_transport.h"

namespace {

using hedgehog::device::FileDescriptor;
using hedgehog::device::SimulatedBoardOptions;
using hedgehog::device::SimulatedBoardRunner;
using hedgehog::device::SocketTransport;

constexpr int kExitUsage = 64;
constexpr int kExitCannotCreate = 73;

constexpr char kUsage[] =
    "usage: hedgehog-simboard --fd N [--start-temperature C] [--ambient C] [--seed N] [--plant P]\n"
    "                         [--front-end E] [--thermistors N] [--parts N] [--trace F]\n"
    "  --fd N                   the inherited SOCK_SEQPACKET socket to the host\n"
    "  --start-temperature C    of the ball, degrees Celsius (default: the room's)\n"
    "  --ambient C              of the room, degrees Celsius (default 25)\n"
    "  --seed N                 of all noise (default 1)\n"
    "  --front-end E            in_line (default), driver_cs or ideal\n"
    "  --thermistors N          1 or 3; 0 (default): three with in_line, one with the others\n"
    "  --parts N                seed of the electronics' parts within their tolerances; 0 "
    "(default): typical ones\n"
    "  --plant P                the ball, as numbers by comma (default: the built-in one)\n"
    "  --trace F                append a JSON line to F at each change of mode and at the end\n";

struct Arguments {
  int fd = -1;
  double ambient_c = 25.0;
  double start_c = 0.0;
  bool start_given = false;
  std::uint64_t seed = 1;
  hedgehog::device::FrontEndChoice front_end;
  std::optional<hedgehog::model::PlantParameters> plant;
  const char* trace = nullptr;
};

template <class Number>
bool parse(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  const auto result = std::from_chars(text, end, number);
  return result.ec == std::errc{} && result.ptr == end;
}

bool read_arguments(int count, char** words, Arguments& arguments) {
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view name = words[i];
    const char* value = words[i + 1];
    bool good = true;
    if (name == "--fd") {
      good = parse(value, arguments.fd);
    } else if (name == "--ambient") {
      good = parse(value, arguments.ambient_c);
    } else if (name == "--start-temperature") {
      good = arguments.start_given = parse(value, arguments.start_c);
    } else if (name == "--seed") {
      good = parse(value, arguments.seed);
    } else if (name == "--front-end") {
      const auto kind = hedgehog::device::front_end_kind(value);
      good = kind.has_value();
      if (good) arguments.front_end.kind = *kind;
    } else if (name == "--thermistors") {
      int& wanted = arguments.front_end.thermistors;
      good = parse(value, wanted) && (wanted == 0 || wanted == 1 || wanted == 3);
    } else if (name == "--parts") {
      good = parse(value, arguments.front_end.seed);
    } else if (name == "--plant") {
      arguments.plant = hedgehog::device::plant_from(value);
      good = arguments.plant.has_value();
    } else if (name == "--trace") {
      arguments.trace = value;
    } else {
      good = false;
    }
    if (!good) return false;
  }
  return count % 2 == 1 && arguments.fd >= 0;
}

}  // namespace

int main(int argument_count, char** words) {
  if (argument_count == 2 && std::string_view(words[1]) == "--version") {
    std::puts("hedgehog-simboard " HEDGEHOG_VERSION);
    return EXIT_SUCCESS;
  }
  if (argument_count == 2 && std::string_view(words[1]) == "--help") {
    std::fputs(kUsage, stdout);
    return EXIT_SUCCESS;
  }
  Arguments arguments;
  if (!read_arguments(argument_count, words, arguments)) {
    std::fputs(kUsage, stderr);
    return kExitUsage;
  }
  std::FILE* trace = nullptr;
  if (arguments.trace != nullptr) {
    trace = std::fopen(arguments.trace, "ae");
    if (trace == nullptr) {
      std::perror(arguments.trace);
      return kExitCannotCreate;
    }
  }
  SimulatedBoardOptions options;
  options.ambient_c = arguments.ambient_c;
  options.start_c = arguments.start_given ? arguments.start_c : arguments.ambient_c;
  if (arguments.plant) options.plant = *arguments.plant;
  options.plant.seed = arguments.seed;
  options.front_end = arguments.front_end;
  SimulatedBoardRunner runner(
      options, std::make_unique<SocketTransport>(FileDescriptor(arguments.fd)), trace);
  const std::atomic<bool> never{false};
  runner.run(never);
  if (trace != nullptr) std::fclose(trace);
  return EXIT_SUCCESS;
}
