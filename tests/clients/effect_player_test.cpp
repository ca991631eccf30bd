// SPDX-License-Identifier: MIT
// Uploads, plays, updates and erases in the order of a game, on virtual time.
#include "clients/gamepad/effect_player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cerrno>

namespace hedgehog::gamepad {
namespace {

using protocol::EffectStart;
using protocol::EffectStop;
using protocol::EffectUpdate;
using testing::ElementsAre;
using testing::IsEmpty;

ff_effect push(int id, int level, int length_ms, int delay_ms = 0) {
  ff_effect effect{};
  effect.type = FF_CONSTANT;
  effect.id = static_cast<std::int16_t>(id);
  effect.u.constant.level = static_cast<std::int16_t>(level);
  effect.replay.length = static_cast<std::uint16_t>(length_ms);
  effect.replay.delay = static_cast<std::uint16_t>(delay_ms);
  return effect;
}

/// "start ff0 200", "start ff0 lease", "renew ff0", "gain ff0", "stop ff0".
std::string text(const protocol::Request& request) {
  if (const auto* start = std::get_if<EffectStart>(&request)) {
    const auto& p = start->params;
    return "start " + *p.slot + " " +
           (p.duration_ms ? std::to_string(*p.duration_ms) : std::string("lease"));
  }
  if (const auto* update = std::get_if<EffectUpdate>(&request))
    return (update->params.gain ? "gain " : "renew ") + *update->params.slot;
  return "stop " + *std::get<EffectStop>(request).slot;
}

class Player : public testing::Test {
 protected:
  std::vector<std::string> new_requests() {
    std::vector<std::string> all;
    for (const auto& request : player_.take_requests()) all.push_back(text(request));
    return all;
  }
  /// Advances in steps of 1 ms, like a loop that is never late.
  void pass(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      now_ += Milliseconds(1);
      player_.advance(now_);
    }
  }

  EffectPlayer player_{TranslationOptions{}};
  TimePoint now_{};
};

TEST_F(Player, AnUploadIsSilentUntilItIsPlayedAndEndsByItsDuration) {
  EXPECT_EQ(player_.upload(push(3, 0x4000, 200), now_), 0);
  EXPECT_THAT(new_requests(), IsEmpty());
  player_.play(3, 1, now_);
  EXPECT_THAT(new_requests(), ElementsAre("start ff3 200"));
  pass(200);
  EXPECT_THAT(new_requests(), IsEmpty()) << "the daemon ends it";
  EXPECT_FALSE(player_.is_playing(3));
  EXPECT_FALSE(player_.deadline());
}

TEST_F(Player, CountRepeatsDelayAndLength) {
  player_.upload(push(0, 0x4000, 100, 50), now_);
  player_.play(0, 3, now_);
  std::vector<int> starts;
  for (int ms = 0; ms <= 500; ++ms) {
    if (!new_requests().empty()) starts.push_back(ms);
    pass(1);
  }
  EXPECT_THAT(starts, ElementsAre(50, 200, 350));
}

TEST_F(Player, ALongOneIsALeaseThatIsRenewedAndStopped) {
  player_.upload(push(0, 0x4000, 20'000), now_);
  player_.play(0, 1, now_);
  EXPECT_THAT(new_requests(), ElementsAre("start ff0 lease"));
  pass(150);
  EXPECT_THAT(new_requests(), ElementsAre("renew ff0"));
  pass(19'849);
  new_requests();
  pass(1);
  EXPECT_THAT(new_requests(), ElementsAre("stop ff0"));
}

TEST_F(Player, OneWithoutAnEndIsStoppedAfterAMinuteAndAnUploadGivesItAnother) {
  player_.upload(push(0, 0x4000, 0), now_);
  player_.play(0, 1, now_);
  pass(59'000);
  EXPECT_TRUE(player_.is_playing(0));
  player_.upload(push(0, 0x4000, 0), now_);
  pass(59'999);
  EXPECT_TRUE(player_.is_playing(0));
  new_requests();
  pass(1);
  EXPECT_THAT(new_requests(), ElementsAre("stop ff0"));
  EXPECT_FALSE(player_.is_playing(0));
}

TEST_F(Player, EndlessRepetitionsEndAfterAMinuteToo) {
  player_.upload(push(0, 0x4000, 5000), now_);
  player_.play(0, 0x7fffffff, now_);
  pass(60'000);
  EXPECT_FALSE(player_.is_playing(0));
}

TEST_F(Player, AnUploadOfAPlayingEffectReplacesItAndOneOfStrengthZeroStopsIt) {
  player_.upload(push(0, 0x4000, 1000), now_);
  player_.play(0, 1, now_);
  pass(900);
  new_requests();
  player_.upload(push(0, 0x2000, 1000), now_);
  EXPECT_THAT(new_requests(), ElementsAre("start ff0 1000"))
      << "in its slot, without a stop before";
  // SDL stops a rumble this way.
  player_.upload(push(0, 0, 1000), now_);
  EXPECT_THAT(new_requests(), ElementsAre("stop ff0"));
  player_.upload(push(0, 0x2000, 1000), now_);
  EXPECT_THAT(new_requests(), ElementsAre("start ff0 1000")) << "it still plays";
}

TEST_F(Player, StopEraseAndTheCloseOfAHandleEndIt) {
  player_.upload(push(0, 0x4000, 1000), now_);
  player_.upload(push(1, 0x4000, 1000), now_);
  player_.play(0, 1, now_);
  player_.play(1, 1, now_);
  new_requests();
  player_.play(0, 0, now_);
  EXPECT_THAT(new_requests(), ElementsAre("stop ff0"));
  EXPECT_EQ(player_.erase(1, now_), 0);
  EXPECT_THAT(new_requests(), ElementsAre("stop ff1"));
  EXPECT_EQ(player_.erase(1, now_), EINVAL);
  player_.play(1, 1, now_);
  EXPECT_THAT(new_requests(), IsEmpty()) << "nobody has uploaded it";
}

TEST_F(Player, TheGainAppliesToPlayingAndFutureEffects) {
  player_.upload(push(0, 0x4000, 1000), now_);
  player_.play(0, 1, now_);
  new_requests();
  player_.set_gain(0x8000);
  auto requests = player_.take_requests();
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_NEAR(*std::get<EffectUpdate>(requests[0]).params.gain, 0.5, 1e-4);
  player_.upload(push(1, 0x4000, 1000), now_);
  player_.play(1, 1, now_);
  requests = player_.take_requests();
  EXPECT_NEAR(*std::get<EffectStart>(requests.at(0)).params.gain, 0.5, 1e-4);
}

TEST_F(Player, UnsupportedEffectsAreRefused) {
  ff_effect spring{};
  spring.type = FF_SPRING;
  EXPECT_EQ(player_.upload(spring, now_), EINVAL);
  EXPECT_EQ(player_.upload(push(16, 1, 1), now_), EINVAL);
  EXPECT_EQ(player_.upload(push(-1, 1, 1), now_), EINVAL);
  player_.play(200, 1, now_);
  player_.play(-1, 1, now_);
  EXPECT_THAT(new_requests(), IsEmpty());
}

TEST_F(Player, ANewConnectionHasTheUploadsAndPlaysNone) {
  player_.upload(push(0, 0x4000, 0), now_);
  player_.play(0, 1, now_);
  player_.on_connect(0.2);
  pass(1000);
  EXPECT_THAT(new_requests(), IsEmpty());
  player_.play(0, 1, now_);
  EXPECT_THAT(new_requests(), ElementsAre("start ff0 lease"));
}

TEST_F(Player, ALateLoopSkipsMissedRepetitions) {
  player_.upload(push(0, 0x4000, 100), now_);
  player_.play(0, 5, now_);
  new_requests();
  now_ += Milliseconds(330);
  player_.advance(now_);
  EXPECT_THAT(new_requests(), ElementsAre("start ff0 100"));
}

RC_GTEST_PROP(PlayerProperty, EveryEffectEndsWithinAMinuteOfTheLastCommand, ()) {
  EffectPlayer player{TranslationOptions{}};
  TimePoint now{};
  const int commands = *rc::gen::inRange(1, 40);
  for (int i = 0; i < commands; ++i) {
    const int id = *rc::gen::inRange(0, 3);
    const int what = *rc::gen::inRange(0, 5);
    if (what <= 1)
      player.upload(push(id, *rc::gen::arbitrary<std::int16_t>(), *rc::gen::inRange(0, 65'536),
                         *rc::gen::inRange(0, 65'536)),
                    now);
    if (what >= 2 && what <= 3) player.play(id, *rc::gen::arbitrary<std::int32_t>(), now);
    if (what == 4) player.set_gain(*rc::gen::inRange(0, 0x10000));
    now += Milliseconds(*rc::gen::inRange(0, 3000));
    player.advance(now);
  }
  now += kMaxPlay;
  player.advance(now);
  RC_ASSERT(!player.deadline());
}

}  // namespace
}  // namespace hedgehog::gamepad
