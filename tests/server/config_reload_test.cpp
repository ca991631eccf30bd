// SPDX-License-Identifier: MIT
// A reload of the configuration does not block, whatever its files and names wait for.
#include "daemon/config_reload.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>

namespace hedgehog::daemon {
namespace {

ConfigReload::Loaded next(ConfigReload& reload, const config::Config& now) {
  for (;;)
    if (auto loaded = reload.step(now)) return *std::move(loaded);
}

TEST(ConfigReload, LoadsOnlyOnRequestAndReturnsEachResultOnce) {
  ConfigReload reload([](const config::Config& now) {
    config::Config fresh = now;
    fresh.state_directory += "/b";
    return fresh;
  });
  config::Config now;
  now.state_directory = "/a";
  EXPECT_FALSE(reload.step(now));
  reload.request();
  EXPECT_EQ(next(reload, now)->state_directory, "/a/b");
  EXPECT_FALSE(reload.step(now));
}

TEST(ConfigReload, DoesNotBlockAndLoadsAgainWhatWasRequestedMeanwhile) {
  std::promise<void> network;
  auto answers = network.get_future().share();
  int loads = 0;
  ConfigReload reload([&](const config::Config& now) {
    answers.wait();
    ++loads;
    return now;
  });
  const config::Config now;
  reload.request();
  EXPECT_FALSE(reload.step(now));
  reload.request();
  reload.request();
  EXPECT_FALSE(reload.step(now));
  network.set_value();
  next(reload, now);
  next(reload, now);
  EXPECT_EQ(loads, 2);
  EXPECT_FALSE(reload.step(now));
}

TEST(ConfigReload, EndsWithoutALoadThatWaits) {
  const auto network = std::make_shared<std::promise<void>>();
  {
    ConfigReload reload([answers = network->get_future().share()](const config::Config& now) {
      answers.wait();
      return now;
    });
    reload.request();
    EXPECT_FALSE(reload.step({}));
  }
  network->set_value();
}

TEST(ConfigReload, ReturnsErrors) {
  ConfigReload reload([](const config::Config&) -> ConfigReload::Loaded {
    return keys::FileErrors{{"hedgehogd.json", 3, "limits", "is wrong"}};
  });
  reload.request();
  EXPECT_EQ(next(reload, {}).error().size(), 1U);
}

}  // namespace
}  // namespace hedgehog::daemon
