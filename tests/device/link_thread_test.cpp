// SPDX-License-Identifier: MIT
// Real threads: the link thread with a simulated board in it, and a simulated board with its own
// clock behind a socket pair. No test asserts a wall time; every wait has minutes.
#include "daemon/device/link_thread.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "daemon/device/simulator/simulated_board_process.h"
#include "daemon/device/simulator/simulated_board_runner.h"
#include "daemon/device/simulator/simulated_board_transport.h"
#include "daemon/device/socket_transport.h"
#include "daemon/device/tick_clock.h"
#include "tests/device/limited.h"
#include "tests/folders.h"

namespace hedgehog::device {
namespace {

std::unique_ptr<Transport> wrap(FileDescriptor socket) {
  return std::make_unique<SocketTransport>(std::move(socket));
}

// Sends a command once a millisecond until `done`; false when that did not happen in two minutes.
template <class Done>
bool drive_until(LinkPort& port, LinkCommand& command, bool driving, Done done) {
  for (int ms = 0; ms < 120'000; ++ms) {
    const LinkReport& report = port.reports.read();
    if (done(report)) return true;
    const std::uint8_t arm_count = command.board.arm_count;
    command.board = driving
                        ? BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0)
                        : BoardCommand{};
    command.board.arm_count = arm_count;
    ++command.count;
    port.commands.write(command);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

// The board's own clock continues while a starved host does nothing: the board has latched by
// itself.
bool latched(const LinkReport& report, const LinkCommand& command) {
  return report.telemetry.mode == BoardMode::kLatched &&
         report.telemetry.arm_count == command.board.arm_count;
}

// An arm request is repeated for 50 ms only: a board that did not run meanwhile has not received
// it.
constexpr int kRearmMs = 2'000;

// Waits until the board drives; arms again when, on a starved machine, the dead-man has tripped
// before or the request was lost. Two minutes of requests.
bool arm_and_drive(LinkPort& port, LinkCommand& command) {
  for (int attempt = 0; attempt < 60; ++attempt) {
    if (!drive_until(port, command, false, [](const LinkReport& r) { return r.present; }))
      return false;
    ++command.board.arm_count;
    bool drives = false;
    int requested_ms = 0;
    drive_until(port, command, true, [&](const LinkReport& r) {
      drives = r.telemetry.mode == BoardMode::kDriving && r.telemetry.current_a.x > 4.0;
      const bool lost =
          ++requested_ms > kRearmMs && r.telemetry.arm_count != command.board.arm_count;
      return drives || !r.present || latched(r, command) || lost;
    });
    if (drives) return true;
  }
  return false;
}

std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> lines;
  std::FILE* file = std::fopen(path.c_str(), "r");
  if (file == nullptr) return lines;
  std::string line;
  for (int c = 0; (c = std::fgetc(file)) != EOF;) {
    line += static_cast<char>(c);
    if (c != '\n') continue;
    lines.push_back(line);
    line.clear();
  }
  std::fclose(file);
  return lines;
}

// The value of `key` in a line of the trace.
std::string value_of(const std::string& line, const std::string& key) {
  const std::size_t at = line.find("\"" + key + "\": ");
  if (at == std::string::npos) return {};
  const std::size_t from = at + key.size() + 4;
  return line.substr(from, line.find_first_of(",}", from) - from);
}

struct Trace {
  std::string path =
      testing::TempDir() + "hedgehog_trace_" + std::to_string(monotonic_ns()) + ".jsonl";
  ~Trace() { std::remove(path.c_str()); }
  // The last line with this event and, if given, this mode.
  std::string line(const std::string& event, const std::string& mode = {}) const {
    std::string found;
    for (const std::string& one : lines_of(path))
      if (value_of(one, "event") == "\"" + event + "\"" &&
          (mode.empty() || value_of(one, "mode") == "\"" + mode + "\""))
        found = one;
    return found;
  }
};

// Safe 100 ms + 1 frame after the last valid set-point by the board's own clock, and without
// current 5 L/R later.
void expect_became_safe(const Trace& trace) {
  const std::string latched = trace.line("mode", "latched");
  ASSERT_FALSE(latched.empty());
  EXPECT_LE(std::stoi(value_of(latched, "set_point_age_ms")), 101);
  EXPECT_EQ(value_of(latched, "faults"), "1");
  EXPECT_EQ(value_of(latched, "awake"), "false");
  EXPECT_EQ(std::stod(value_of(latched, "duty")), 0.0);
  const std::string zero = trace.line("zero");
  ASSERT_FALSE(zero.empty());
  EXPECT_LE(std::stoi(value_of(zero, "board_ms")), std::stoi(value_of(latched, "board_ms")) + 17);
  const std::string exit = trace.line("exit");
  ASSERT_FALSE(exit.empty());
  EXPECT_LT(std::stod(value_of(exit, "current_a")), 0.1);
}

TEST(LinkThreads, DriveAnArmedSimulatedBoard) {
  LinkPort port;
  LinkThread link(port, std::make_unique<SimulatedBoardTransport>(SimulatedBoardOptions{}));
  LinkCommand command;
  ASSERT_TRUE(arm_and_drive(port, command));
  const LinkReport report = port.reports.read();
  EXPECT_GT(report.counters.frames_out, 0u);
  EXPECT_EQ(report.counters.errors, 0u);
}

TEST(LinkThreads, SimulatorSettingsReachTheBoard) {
  LinkPort port;
  LinkThread link(port, std::make_unique<SimulatedBoardTransport>(SimulatedBoardOptions{}));
  LinkCommand command;
  SimulatorSettings settings;
  settings.faults = kSimSensorOpen;
  port.simulator.write(settings);
  EXPECT_TRUE(drive_until(port, command, false, [](const LinkReport& r) {
    return (r.telemetry.faults & board::kSensorOpen) != 0;
  }));
}

TEST(LinkThreads, TheBoardBecomesSafeWhenTheHostCloses) {
  const Trace trace;
  auto [host, board] = make_socket_pair();
  std::FILE* file = std::fopen(trace.path.c_str(), "w");
  ASSERT_NE(file, nullptr);
  SimulatedBoardRunner runner({}, wrap(std::move(board)), file);
  const std::atomic<bool> never{false};
  std::thread thread([&] { runner.run(never); });
  std::unique_ptr<Transport> transport = wrap(std::move(host));
  // A host that drives and then disappears without a frame.
  Link link;
  LinkCommand command;
  int requested_ms = 0;
  for (int ms = 0; ms < 120'000 && !(link.report().telemetry.current_a.x > 4.0); ++ms) {
    Frame packet;
    while (transport->receive(packet) != 0) link.receive(packet);
    if (link.report().present) {
      const std::uint8_t armed = command.board.arm_count;
      const bool lost = ms > requested_ms + kRearmMs && link.report().telemetry.arm_count != armed;
      const bool again = armed == 0 || latched(link.report(), command) || lost;
      if (again) requested_ms = ms;
      command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
      command.board.arm_count = static_cast<std::uint8_t>(armed + (again ? 1 : 0));
    }
    ++command.count;
    const LinkFrames frames = link.step(command);
    transport->send(frames.set_point);
    if (frames.other) transport->send(*frames.other);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  transport.reset();
  thread.join();
  std::fclose(file);
  ASSERT_GT(link.report().telemetry.current_a.x, 4.0);
  expect_became_safe(trace);
  EXPECT_FALSE(trace.line("closed").empty());
}

TEST(SimulatedBoardProcesses, BecomeSafeWhenTheirHostEnds) {
  const Trace trace;
  SimulatedBoardProcessOptions options;
  options.program = build_folder() + "/daemon/hedgehog-simboard";
  options.trace = trace.path;
  options.board.start_c = 30.0;
  options.board.plant.supply_v = 14.0;
  {
    SimulatedBoardProcess process(options);
    LinkPort port;
    LinkThread link(port, process.take_transport());
    LinkCommand command;
    ASSERT_TRUE(arm_and_drive(port, command));
    EXPECT_NEAR(port.reports.read().telemetry.supply_v, 14.0, 0.05);
    EXPECT_NEAR(port.reports.read().telemetry.sensor_c, 30.0, 3.0);
  }
  expect_became_safe(trace);
}

TEST(SimulatedBoardProcesses, AProgramThatIsMissingIsAnError) {
  SimulatedBoardProcessOptions options;
  options.program = testing::TempDir() + "no_such_program";
  EXPECT_THROW(SimulatedBoardProcess{options}, std::system_error);
}

TEST(TickClock, APhaseIsThatOfWholeMilliseconds) {
  constexpr std::int64_t kPhaseNs = 250'000;
  EXPECT_EQ(at_phase_before(7'250'000, kPhaseNs), 7'250'000);
  EXPECT_EQ(at_phase_before(8'249'999, kPhaseNs), 7'250'000);
}

TEST(TickClock, SleepsAreNotDelayedWhereTheSystemAllowsNoRealTimeScheduling) {
  constexpr int kInvalidPriority = 0;
  bool allowed = true;
  int slack_ns = 0;
  std::thread([&] {
    allowed = use_fifo(kInvalidPriority);
    slack_ns = prctl(PR_GET_TIMERSLACK);
  }).join();
  EXPECT_FALSE(allowed);
  EXPECT_EQ(slack_ns, 1);
}

TEST(TickClock, SkipsMissedTicksInsteadOfCatchingUp) {
  TickClock clock(1'000'000);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const std::uint64_t skipped = clock.wait();
  EXPECT_GE(skipped, 40u);
  EXPECT_GE(clock.lateness_ns(), 0);
}

TEST(SocketTransport, KeepsLengthsAndDetectsTheEnd) {
  auto [one, other] = make_socket_pair();
  SocketTransport near(std::move(one));
  Frame frame{};
  frame[5] = 42;
  {
    SocketTransport far(std::move(other));
    EXPECT_TRUE(near.send(frame));
    std::array<std::uint8_t, 128> packet{};
    EXPECT_EQ(far.receive(packet), 64u);
    EXPECT_EQ(packet[5], 42);
    EXPECT_EQ(far.receive(packet), 0u);
    EXPECT_TRUE(far.open());
  }
  std::array<std::uint8_t, 128> packet{};
  EXPECT_EQ(near.receive(packet), 0u);
  EXPECT_FALSE(near.open());
  EXPECT_FALSE(near.send(frame));
}

TEST(SocketTransport, AFullSocketDropsInsteadOfWaiting) {
  auto [one, other] = make_socket_pair();
  SocketTransport near(std::move(one));
  const Frame frame{};
  int accepted = 0;
  while (accepted < 100'000 && near.send(frame)) ++accepted;
  EXPECT_LT(accepted, 200) << "old set-points must not pile up";
  EXPECT_TRUE(near.open());
}

}  // namespace
}  // namespace hedgehog::device
