// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/discovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "clients/ctl/discover/discovery_screen.h"
#include "tests/temporary_folder.h"

namespace hedgehog::client {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kBrowsed =
    "+;eth0;IPv6;ball-7;_hedgehog._tcp;local\n"
    "+;eth0;IPv4;ball-7;_hedgehog._tcp;local\n"
    "=;eth0;IPv6;ball-7;_hedgehog._tcp;local;lab.local;fe80::1;7586;\"serial=7\"\n"
    "=;eth0;IPv4;ball-7;_hedgehog._tcp;local;lab.local;192.0.2.7;7586;"
    "\"tls=1\" \"serial=7\" \"protocol=1.0\"\n"
    "=;wlan0;IPv4;ball-7;_hedgehog._tcp;local;lab.local;192.0.2.7;7586;\"tls=1\"\n"
    "=;eth0;IPv4;Anna\\039s\\032ball\\.2;_hedgehog._tcp;local;anna.local;192.0.2.9;17586;\n";

TEST(AvahiBrowse, ReadsNameAddressAndRecordsOfEachService) {
  const std::vector<DiscoveredBall> daemons = parse_avahi_browse(kBrowsed);
  ASSERT_EQ(daemons.size(), 2u) << "one of a name and address, none of a link";
  EXPECT_EQ(daemons[0].name, "Anna's ball.2");
  EXPECT_EQ(to_string(daemons[0].address), "192.0.2.9:17586");
  EXPECT_EQ(daemons[0].serial, std::nullopt);
  EXPECT_FALSE(daemons[0].address.tls);
  EXPECT_EQ(daemons[1].name, "ball-7");
  EXPECT_EQ(daemons[1].host, "lab.local");
  EXPECT_EQ(daemons[1].serial, "7");
  EXPECT_EQ(daemons[1].protocol, "1.0");
  EXPECT_TRUE(daemons[1].address.tls);
}

TEST(AvahiBrowse, KeepsALinkLocalAddressThatIsTheOnlyOne) {
  const auto daemons =
      parse_avahi_browse("=;eth0;IPv6;a;_hedgehog._tcp;local;h.local;fe80::1;7586;\"tls=1\"\n");
  ASSERT_EQ(daemons.size(), 1u);
  EXPECT_EQ(to_string(daemons[0].address), "tls://[fe80::1]:7586");
}

TEST(AvahiBrowse, RemovesControlCharactersFromTheNetwork) {
  const auto daemons = parse_avahi_browse(
      "=;e;IPv4;\\027[2J\\194\\155x\\255;_hedgehog._tcp;local;h\\010;192.0.2.1;7586;"
      "\"serial=a\\\"b\\007\"\n");
  ASSERT_EQ(daemons.size(), 1u);
  EXPECT_EQ(daemons[0].name, "?[2J?x\xef\xbf\xbd");
  EXPECT_EQ(daemons[0].host, "h?");
  EXPECT_EQ(daemons[0].serial, "a\"b?");
}

TEST(AvahiBrowse, IgnoresOtherRecords) {
  for (const char* line : {"", "=", "=;;;;;;;;;", "=;e;IPv4;a;_hedgehog._tcp;local;h;192.0.2.1;0;",
                           "=;e;IPv4;a;_hedgehog._tcp;local;h;192.0.2.1;99999;",
                           "=;e;IPv4;a\\;_hedgehog._tcp;local;h;;7586;", "\\", "=;\\0;\""})
    EXPECT_THAT(parse_avahi_browse(line), IsEmpty()) << line;
  EXPECT_EQ(parse_avahi_browse("=;e;IPv4;a;t;l;h;192.0.2.1;1;\"serial=7\\").size(), 1u);
}

/// A bound Unix socket without a listener.
void bind_socket(const std::string& path) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address), 0) << path;
  ::close(socket);
}

TEST(LocalDaemons, AreTheServiceAndItsInstancesByName) {
  const TemporaryFolder folder;
  for (const char* place : {"", "ball-9/", "ball-7/"})
    bind_socket(folder.path(std::string(place) + "hedgehogd.sock"));
  std::filesystem::create_directories(folder.path("empty"));
  const auto environment = [&](const std::string& name) {
    return name == "RUNTIME_DIRECTORY" ? std::optional(folder.path()) : std::nullopt;
  };
  std::vector<std::string> instances;
  for (const LocalDaemon& daemon : local_daemons(environment)) instances.push_back(daemon.instance);
  EXPECT_THAT(instances, ElementsAre("hedgehogd", "ball-7", "ball-9"));
  EXPECT_EQ(local_daemons(environment)[1].socket, folder.path("ball-7/hedgehogd.sock"));
  EXPECT_THAT(running_daemons(environment), IsEmpty()) << "killed daemons leave their sockets";
}

Discovery example() {
  Discovery discovery;
  protocol::HelloResult hello;
  hello.state = "armed";
  hello.device = {.name = "ball-7", .model = "hedgehog-86", .simulated = true};
  discovery.local = {
      {{"ball-7", "/run/hedgehog/ball-7/hedgehogd.sock"}, hello, "0007", ""},
      {{"ball-9", "/run/hedgehog/ball-9/hedgehogd.sock"}, {}, {}, "does not respond"}};
  discovery.network.daemons = parse_avahi_browse(kBrowsed);
  return discovery;
}

TEST(DiscoveryScreen, HasTheWholeAddressOfEachBall) {
  const std::vector<std::string> lines = discovery_screen(example());
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[1],
            "  ball-7 (simulated)        armed          /run/hedgehog/ball-7/hedgehogd.sock");
  EXPECT_THAT(lines[2], HasSubstr("ball-9"));
  EXPECT_THAT(lines[2], HasSubstr("does not res…"));
  EXPECT_THAT(lines[4], testing::EndsWith("network, TLS   tls://192.0.2.7:7586"));
  EXPECT_THAT(discovery_screen({}), ElementsAre("  no ball was found"));
}

TEST(DiscoveryScreen, IsJsonForPrograms) {
  const json object = json::parse(discovery_json(example()));
  EXPECT_EQ(object["local"][0],
            json::parse(R"({"instance":"ball-7","address":"/run/hedgehog/ball-7/hedgehogd.sock",
                            "name":"ball-7","model":"hedgehog-86","simulated":true,
                            "state":"armed","protocol":"1.0","serial":"0007"})"));
  EXPECT_EQ(object["local"][1]["failure"], "does not respond");
  EXPECT_EQ(object["network"][1],
            json::parse(R"({"name":"ball-7","host":"lab.local","address":"tls://192.0.2.7:7586",
                            "serial":"7","protocol":"1.0","tls":true})"));
  EXPECT_TRUE(object["network_failure"].is_null());
}

}  // namespace
}  // namespace hedgehog::client
