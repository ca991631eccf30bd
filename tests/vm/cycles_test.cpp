// SPDX-License-Identifier: MIT
// Three hundred plug cycles: board, MTi and TEMPer stick, a hundred times each, with one daemon.
#include <algorithm>
#include <cstdlib>

#include "tests/vm/bench.h"

namespace hedgehog::vm {
namespace {

class Cycles : public Bench {
 protected:
  Cycles() : Bench({"board,unplugged", "mti,unplugged", "temper,unplugged"}) {}

  /// Fills the history to its limit, so that another event does not increase memory.
  void fill_history() const {
    constexpr int kEntries = 5000;
    constexpr const char* kLine =
        R"({"at":"2026-11-22T05:20:07.189Z","type":"state_changed","time_ns":63799163147742,)"
        R"("state":"disarmed","reason":"hot_plugged","remedy":"Run: hedgehogctl arm"})"
        "\n";
    std::string lines;
    for (int i = 0; i < kEntries; ++i) lines += kLine;
    home_.write("state/hedgehog/events.jsonl", lines);
  }

  int number(const char* device, const char* what) const { return emulator_->status(device)[what]; }
};

TEST_F(Cycles, LeakNoDescriptorAndNoMemory) {
  constexpr int kRounds = 100;
  constexpr int kWarm = 50;
  configure({{"imu", {{"type", "mti"}}}, {"thermometer", {{"type", "temper"}, {"role", "shell"}}}});
  fill_history();
  // With one arena, chance differences in sharing memory between threads do not count as growth.
  Daemon daemon(home_, "", {"MALLOC_ARENA_MAX=1"});
  int descriptors = 0;
  int memory_kib = 0;
  double longest_ms = 0.0;
  const double from = now_ms();
  for (int round = 1; round <= kRounds; ++round) {
    const int frames = number("board", "frames_in");
    const int reports = number("mti", "reports");
    const int before = number("temper", "asked");
    const double plugged_ms = now_ms();
    for (const char* device : {"plug board", "plug mti", "plug temper"}) emulator_->ok(device);
    // Seldom, because otherwise the emulated processor would spend most of its time on responses.
    constexpr int kPollMs = 50;
    ASSERT_TRUE(eventually(
        [&] {
          return number("board", "frames_in") > frames && number("mti", "reports") > reports &&
                 number("temper", "asked") > before;
        },
        kPollMs))
        << "round " << round << "\n"
        << daemon.log();
    longest_ms = std::max(longest_ms, now_ms() - plugged_ms);
    // Alternates between an orderly and an abrupt disconnection, in changing order.
    for (int i = 0; i < 3; ++i) {
      constexpr const char* kNames[] = {"board", "mti", "temper"};
      emulator_->ok(std::string(round % 2 == 0 ? "unplug " : "cut ") + kNames[(round + i) % 3]);
    }
    ASSERT_TRUE(daemon.is("absent"));
    if (round == kWarm) {
      descriptors = daemon.descriptors();
      memory_kib = daemon.memory_kib();
    }
  }
  ASSERT_TRUE(eventually([&] { return daemon.descriptors() <= descriptors; }))
      << daemon.descriptors() << " descriptors, after " << kWarm << " rounds " << descriptors;
  const int grown_kib = daemon.memory_kib() - memory_kib;
  EXPECT_LT(grown_kib, 256);
  figure("plug cycles", 3 * kRounds, "");
  figure("the longest from plug to all three at work", longest_ms, "ms");
  figure("the mean round", (now_ms() - from) / kRounds, "ms");
  figure("descriptors open after " + std::to_string(kWarm) + " rounds", descriptors, "");
  figure("descriptors open after " + std::to_string(kRounds) + " rounds", daemon.descriptors(), "");
  figure("memory grown meanwhile", grown_kib, "KiB");
  EXPECT_EQ(daemon.stop(), 0);
}

}  // namespace
}  // namespace hedgehog::vm
