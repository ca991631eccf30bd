// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/felt_sides.h"

#include <cstdio>
#include <iostream>

#include "clients/common/interrupts.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

ClientError stopped(const std::string& why) { return {Failure::kClosed, why, {}}; }

Outcome<std::string> answer_to(const std::string& question) {
  std::printf("%s", question.c_str());
  std::fflush(stdout);
  std::string answer;
  if (!std::getline(std::cin, answer)) {
    std::puts("");
    return stopped(interrupted() ? "interrupted" : "no answer; nothing was written");
  }
  if (interrupted()) return stopped("interrupted");
  return answer;
}

/// Repeats the push until the answer is a side.
Outcome<std::string> side_of(WindingBench& bench, std::size_t winding, double push_a) {
  for (;;) {
    if (auto pushed = bench.push(static_cast<int>(winding), push_a); !pushed) return pushed.error();
    const auto answer = answer_to(std::string("  ") + kAxisNames[winding] + " pushes now, where? ");
    if (!answer) return answer.error();
    if (const std::string side = side_meant(*answer); !side.empty()) return side;
    if (answer->find_first_not_of(" \t\r") == std::string::npos) continue;
    std::printf("  \"%s\" is no side. front, back, left, right, up, down; Enter: once more.\n",
                cut(*answer, 14).c_str());
  }
}

}  // namespace

Outcome<PushedSides> prompt_sides(WindingBench& bench, double push_a) {
  std::printf(
      "\nNow by hand: hold the ball with its arrow to the front, its cable towards you.\n"
      "Each winding pushes once, %s A. Say where the pins come out most: front, back,\n"
      "left, right, up or down (a letter will do); Enter alone: the same push again.\n",
      fixed(push_a, 0).c_str());
  if (const auto ready = answer_to("  Enter when you hold it: "); !ready) return ready.error();
  PushedSides felt;
  for (std::size_t winding = 0; winding < 3;) {
    auto side = side_of(bench, winding, push_a);
    if (!side) return side.error();
    felt.side[winding] = *std::move(side);
    const auto conflicting = same_axis(felt, winding);
    ++winding;
    if (!conflicting) continue;
    std::printf("  %c %s and %c %s are on one axis, but each winding has its own. Feel again:\n",
                kAxisNames[*conflicting], felt.side[*conflicting].c_str(), kAxisNames[winding - 1],
                felt.side[winding - 1].c_str());
    felt = {};
    winding = 0;
  }
  if (is_left_handed(felt)) {
    std::puts(
        "  That is left-handed: two windings are swapped, or one is the other way round.\n"
        "  The file says so, nothing has to be changed.");
  }
  return felt;
}

}  // namespace hedgehog::client
