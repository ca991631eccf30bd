// SPDX-License-Identifier: MIT
// hedgehog-simboard: the simulated driver board as a separate process with an inherited socket. It
// continues after the end of its host until it is in a safe state.

#include <sysexits.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "cli/program.h"
#include "daemon/device/simulator/plant_text.h"
#include "daemon/device/simulator/simulated_board_runner.h"
#include "daemon/device/socket_transport.h"

namespace {

using hedgehog::device::FileDescriptor;
using hedgehog::device::SimulatedBoardOptions;
using hedgehog::device::SimulatedBoardRunner;
using hedgehog::device::SocketTransport;

constexpr int kDaemonSection = 8;

struct Arguments {
  int fd = -1;
  double ambient_c = 25.0;
  std::optional<double> start_c;
  std::uint64_t seed = 1;
  hedgehog::device::FrontEndChoice front_end;
  bool in_step = false;
  std::optional<hedgehog::model::PlantParameters> plant;
  std::string trace;
};

/// The arguments, or the exit code of a command line that ends at once.
std::variant<Arguments, int> parse_arguments(int argc, const char* const* argv) {
  Arguments arguments;
  std::string front_end = "in_line";
  std::string plant;
  hedgehog::cli::Program app(
      "hedgehog-simboard: the simulated driver board as a process. hedgehogd starts it.",
      "hedgehog-simboard");
  app.set_version("hedgehog-simboard " HEDGEHOG_VERSION);
  app.add_option("--fd", arguments.fd, "the inherited SOCK_SEQPACKET socket to the host")
      .type_name("N")
      .non_negative()
      .required();
  app.add_option("--start-temperature", arguments.start_c,
                 "of the ball, degrees Celsius; default: the ambient temperature")
      .type_name("C");
  app.add_option("--ambient", arguments.ambient_c,
                 "temperature of the surroundings, degrees Celsius")
      .type_name("C")
      .show_default();
  app.add_option("--seed", arguments.seed, "of all noise").type_name("N").show_default();
  app.add_option("--plant", plant,
                 "the ball, as numbers separated by commas; default: the built-in one")
      .type_name("P");
  app.add_option("--front-end", front_end, "the electronics that measure the currents")
      .one_of({"in_line", "driver_cs", "ideal"})
      .show_default();
  app.add_option("--thermistors", arguments.front_end.thermistors,
                 "1 or 3; 0: three with in_line, one with the others")
      .one_of({0, 1, 3})
      .show_default();
  app.add_option("--parts", arguments.front_end.seed,
                 "seed of the electronics' parts within their tolerances; 0: typical ones")
      .type_name("N")
      .show_default();
  app.add_flag("--in-step", arguments.in_step,
               "a millisecond for each set-point, for a host that waits for it");
  app.add_option("--trace", arguments.trace,
                 "append a JSON line to this file at each change of mode and at the end")
      .type_name("F");
  if (const auto code = app.parse_and_print(argc, argv, kDaemonSection)) return *code;
  arguments.front_end.kind = *hedgehog::device::front_end_kind(front_end);
  if (!plant.empty()) arguments.plant = hedgehog::device::plant_from(plant);
  if (!plant.empty() && !arguments.plant) {
    const std::string what = "--plant: '" + plant + "' is no list of a ball's numbers";
    std::fprintf(stderr, "%s\n", app.usage_error(what).c_str());
    return EX_USAGE;
  }
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  const auto parsed = parse_arguments(argc, argv);
  if (const int* code = std::get_if<int>(&parsed)) return *code;
  const Arguments& arguments = std::get<Arguments>(parsed);
  std::FILE* trace = nullptr;
  if (!arguments.trace.empty()) {
    trace = std::fopen(arguments.trace.c_str(), "ae");
    if (trace == nullptr) {
      std::perror(arguments.trace.c_str());
      return EX_CANTCREAT;
    }
  }
  SimulatedBoardOptions options;
  options.ambient_c = arguments.ambient_c;
  options.start_c = arguments.start_c.value_or(arguments.ambient_c);
  if (arguments.plant) options.plant = *arguments.plant;
  options.plant.seed = arguments.seed;
  options.front_end = arguments.front_end;
  auto socket = std::make_unique<SocketTransport>(FileDescriptor(arguments.fd));
  const SocketTransport& host = *socket;
  SimulatedBoardRunner runner(options, std::move(socket), trace);
  if (arguments.in_step) runner.run_in_step(host);
  const std::atomic<bool> never{false};
  runner.run(never);
  if (trace != nullptr) std::fclose(trace);
  return EXIT_SUCCESS;
}
