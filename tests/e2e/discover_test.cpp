// SPDX-License-Identifier: MIT
// Several daemons on one machine, discovered by hedgehogctl and used at the same time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/exit_codes.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/e2e/raw_client.h"
#include "tests/mdns_responder.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// hedgehogd and hedgehogd@ball-7 with the folders that systemd assigns to them.
class Discover : public testing::Test {
 protected:
  Discover() {
    // No avahi-browse, unless a test creates one.
    std::filesystem::create_directories(home_.path("bin"));
  }
  std::vector<std::string> service(const std::string& instance) const {
    const std::string below = instance.empty() ? "" : "/" + instance;
    std::filesystem::create_directories(home_.path("service" + below));
    return {"RUNTIME_DIRECTORY=" + home_.path("service" + below),
            "STATE_DIRECTORY=" + home_.path("state" + below)};
  }
  Ended ctl(const std::vector<std::string>& arguments) const {
    return Program(home_, hedgehogctl(), arguments,
                   {"RUNTIME_DIRECTORY=" + home_.path("service"), "PATH=" + home_.path("bin"),
                    "HEDGEHOG_MDNS_PORT=" + std::to_string(mdns_port_)})
        .wait();
  }
  void write_avahi_browse(const std::string& script) const {
    home_.write("bin/avahi-browse", "#!/bin/sh\n" + script);
    std::filesystem::permissions(home_.path("bin/avahi-browse"), std::filesystem::perms::owner_all);
  }

  Home home_;
  /// No responder listens there, unless a test starts one.
  std::uint16_t mdns_port_ = 9;
  // The output files of both have the same names: the first is read before the second starts.
  DaemonProcess single_{home_, {}, service("")};
  Home other_home_;
  DaemonProcess instance_{other_home_, {}, service("ball-7")};
};

TEST_F(Discover, ListsTheInstancesOfThisMachine) {
  const Ended text = ctl({"discover"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr(single_.socket() + "\n"));
  EXPECT_THAT(text.out, HasSubstr(instance_.socket() + "\n"));
  EXPECT_THAT(text.err, IsEmpty());
  const Ended as_json = ctl({"discover", "--json"});
  EXPECT_THAT(as_json.err, IsEmpty());
  const Json found = Json::parse(as_json.out);
  ASSERT_EQ(found["local"].size(), 2u);
  EXPECT_EQ(found["local"][1]["instance"], "ball-7");
  EXPECT_EQ(found["local"][1]["address"], instance_.socket());
  EXPECT_EQ(found["local"][1]["simulated"], true);
  EXPECT_EQ(found["network"], Json::array());
  EXPECT_EQ(found["network_failure"], nullptr);
}

TEST_F(Discover, ListsTheRespondingBallsWithoutAvahi) {
  const MdnsResponder responder(mdns_announcement("192.0.2.9", 7587));
  mdns_port_ = responder.port();
  const Ended ended = ctl({"discover", "--json"});
  const Json network = Json::parse(ended.out)["network"];
  ASSERT_EQ(network.size(), 1u) << ended.out << ended.err;
  EXPECT_EQ(network[0]["name"], "ball-7");
  EXPECT_EQ(network[0]["address"], "tls://192.0.2.9:7587");
  EXPECT_EQ(network[0]["serial"], "0007");
}

TEST_F(Discover, ListsTheBallsOfAvahi) {
  write_avahi_browse(
      "[ \"$*\" = '--parsable --resolve --terminate --no-db-lookup _hedgehog._tcp' ] || exit 9\n"
      "echo '=;eth0;IPv4;ball-9;_hedgehog._tcp;local;lab.local;192.0.2.9;7586;\"tls=1\"'\n");
  const Ended ended = ctl({"discover"});
  EXPECT_THAT(ended.out, HasSubstr("192.0.2.9:7586"));
  EXPECT_THAT(ended.err, IsEmpty());
}

TEST_F(Discover, ReportsAnAvahiThatDoesNotRun) {
  write_avahi_browse("echo 'Failed to create client object: Daemon not running' >&2; exit 1\n");
  const Ended ended = ctl({"discover"});
  EXPECT_EQ(ended.exit_code, 0) << "the balls of this machine are there";
  EXPECT_THAT(ended.err, HasSubstr("the network was not searched: Failed to create client object: "
                                   "Daemon not running (systemctl status avahi-daemon)"));
}

TEST_F(Discover, FindsNoneWhereNoneRuns) {
  single_.stop(SIGKILL);
  instance_.stop(SIGKILL);
  const Ended ended = ctl({"discover"});
  EXPECT_EQ(ended.exit_code, kUnavailable);
  EXPECT_THAT(ended.out, HasSubstr("no ball was found"));
  const Ended all = ctl({"--all", "status"});
  EXPECT_EQ(all.exit_code, kUnavailable);
  EXPECT_THAT(all.err, HasSubstr("no daemon runs on this machine"));
}

TEST_F(Discover, AllStopsEveryBall) {
  const Ended stopped = ctl({"--all", "stop"});
  EXPECT_EQ(stopped.exit_code, 0) << stopped.err;
  for (const DaemonProcess* daemon : {&single_, &instance_})
    EXPECT_EQ(RawClient(daemon->port()).call("device.status")["state"], "disarmed");
  EXPECT_THAT(stopped.out, HasSubstr("hedgehogd: "));
  EXPECT_THAT(stopped.out, HasSubstr("ball-7: "));
}

TEST_F(Discover, AllPrintsALineOfJsonForEachBall) {
  const Ended ended = ctl({"status", "--all", "--json"});
  EXPECT_EQ(ended.exit_code, 0);
  std::istringstream lines(ended.out);
  std::vector<std::string> instances;
  for (std::string line; std::getline(lines, line);) {
    const Json object = Json::parse(line);
    EXPECT_EQ(object["response"]["state"], "armed");
    instances.push_back(object["instance"].get<std::string>());
  }
  EXPECT_THAT(instances, testing::UnorderedElementsAre("hedgehogd", "ball-7"));
}

TEST_F(Discover, AllHasTheHighestExitCode) {
  RawClient(instance_.port()).call("device.emergency_stop");
  const Ended pulse = ctl({"--all", "pulse", "left"});
  EXPECT_EQ(pulse.exit_code, kUnavailable) << "one of both is disarmed";
  EXPECT_THAT(pulse.err, HasSubstr("ball-7: "));
  EXPECT_THAT(pulse.out, HasSubstr("hedgehogd: "));
  EXPECT_THAT(pulse.out, Not(HasSubstr("ball-7: ")));
}

TEST_F(Discover, AHungDaemonDelaysNoOther) {
  instance_.signal(SIGSTOP);
  Program stop(home_, hedgehogctl(), {"--all", "stop"},
               {"RUNTIME_DIRECTORY=" + home_.path("service"), "PATH=" + home_.path("bin")});
  RawClient client(single_.port());
  EXPECT_TRUE(eventually([&] { return client.call("device.status")["state"] == "disarmed"; }));
  EXPECT_TRUE(stop.prints("hedgehogd: ")) << "while the other is still waited for";
  instance_.signal(SIGCONT);
  EXPECT_EQ(stop.wait().exit_code, 0);
}

TEST_F(Discover, AnInterruptEndsAllOfThem) {
  Program hold(home_, hedgehogctl(), {"--all", "hold", "up"},
               {"RUNTIME_DIRECTORY=" + home_.path("service"), "PATH=" + home_.path("bin")});
  const auto plays = [](const DaemonProcess& daemon) {
    return !RawClient(daemon.port()).call("device.status")["effects"].empty();
  };
  ASSERT_TRUE(eventually([&] { return plays(single_) && plays(instance_); }));
  hold.signal(SIGTERM);
  hold.wait();
  EXPECT_TRUE(eventually([&] { return !plays(single_) && !plays(instance_); }));
}

TEST_F(Discover, AllRefusesWhatNeedsOneBall) {
  for (const char* verb : {"watch", "demo", "discover"}) {
    const Ended ended = ctl({"--all", verb});
    EXPECT_EQ(ended.exit_code, kUsage) << verb;
    EXPECT_THAT(ended.err, HasSubstr("works with one daemon at a time"));
  }
  EXPECT_EQ(ctl({"--all", "--address", "127.0.0.1", "status"}).exit_code, kUsage);
}

}  // namespace
}  // namespace hedgehog::e2e
