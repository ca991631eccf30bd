// SPDX-License-Identifier: MIT
// What hedgehogctl tunnel refuses and bounds: addresses, web pages, clients that do not read, many
// of them; and how it ends.
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/e2e/tunnel_fixture.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;

constexpr int kMaxTunnelClients = 32;

class TunnelLimits : public TunnelFixture {
 protected:
  /// Peak of its memory.
  static int peak_kb(const Program& program) {
    std::ifstream status("/proc/" + std::to_string(program.pid()) + "/status");
    const std::string name = "VmHWM:";
    for (std::string line; std::getline(status, line);)
      if (line.starts_with(name)) return std::stoi(line.substr(name.size()));
    throw std::runtime_error("the tunnel has ended");
  }

  /// AddressSanitizer keeps what was freed for as long as its quarantine has space, 256 MB by
  /// default.
  static std::string small_quarantine() {
    const char* options = std::getenv("ASAN_OPTIONS");
    return std::string("ASAN_OPTIONS=") + (options ? options : "") + ":quarantine_size_mb=1";
  }
};

TEST_F(TunnelLimits, OnlyABallOnTheNetworkIsAllowed) {
  for (const std::string address : {"127.0.0.1:7586", "ball-host:7586", "/run/x.sock"}) {
    const Ended ended = ctl({"tunnel", address}, {});
    EXPECT_EQ(ended.exit_code, kUsage) << address;
    EXPECT_THAT(ended.err, HasSubstr("tls://host:port or mdns://NAME, not to " + address));
  }
  EXPECT_EQ(ctl({"tunnel"}, {}).exit_code, kUsage) << "this machine's daemon is no such ball";
  const Ended pinned = ctl({"tunnel", "mdns://"}, {});
  EXPECT_EQ(pinned.exit_code, kUsage);
  EXPECT_THAT(pinned.err, HasSubstr("needs a fingerprint"));
  EXPECT_EQ(ctl({"--address", tls_address(), "tunnel", tls_address()}, {}).exit_code, kUsage);
  EXPECT_EQ(ctl({"--all", "tunnel"}, {}).exit_code, kUsage);
  EXPECT_EQ(ctl({"tunnel", tls_address(), "--port", "65536"}, {}).exit_code, kUsage);
}

TEST_F(TunnelLimits, IsReachableFromThisMachineOnly) {
  TunnelProcess tunnel(home_, variables(play_));
  const auto reached = [&](const std::string& host) {
    return Program(home_, "/bin/sh", {"-c", "nc -z " + host + " " + std::to_string(tunnel.port())})
               .wait()
               .exit_code == 0;
  };
  EXPECT_TRUE(reached("127.0.0.1"));
  EXPECT_FALSE(reached("127.0.0.2")) << "listens on every address";
}

TEST_F(TunnelLimits, APortInUseIsReported) {
  const Ended ended = ctl({"tunnel", "--port", std::to_string(daemon_->port())}, variables(play_));
  EXPECT_EQ(ended.exit_code, kCannotCreate);
  EXPECT_THAT(ended.err, HasSubstr("127.0.0.1:" + std::to_string(daemon_->port()) +
                                   ": address already in use"));
  EXPECT_THAT(ended.err, HasSubstr("--port"));
}

TEST_F(TunnelLimits, JsonHasAddressesAndRole) {
  Program tunnel(home_, hedgehogctl(), {"tunnel", "--json", "--port", "0"}, variables(operate_));
  ASSERT_TRUE(tunnel.prints("\n")) << tunnel.err();
  const Json line = Json::parse(tunnel.out());
  EXPECT_EQ(line["address"], tls_address());
  EXPECT_EQ(line["role"], "operate");
  EXPECT_THAT(line["listening"].get<std::string>(), testing::StartsWith("127.0.0.1:"));
  EXPECT_EQ(tunnel.err(), "");
}

TEST_F(TunnelLimits, AnInterruptEndsItAndItsClients) {
  TunnelProcess tunnel(home_, variables(play_));
  RawClient game(tunnel.port());
  hold(game);
  tunnel.program().signal(SIGINT);
  EXPECT_EQ(tunnel.program().wait().exit_code, kInterrupted);
  EXPECT_TRUE(game.closed_by_daemon());
  EXPECT_TRUE(plays_nothing());
}

TEST_F(TunnelLimits, ARequestOfAWebPageIsNotRelayed) {
  TunnelProcess tunnel(home_, variables(play_));
  const std::string stop = R"({"jsonrpc":"2.0","method":"device.emergency_stop"})"
                           "\n";
  RawClient page(tunnel.port());
  page.send("\r\nPOST / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n" + stop);
  EXPECT_TRUE(page.closed_by_daemon());
  EXPECT_EQ(status()["state"], "armed");
  RawClient game(tunnel.port());
  game.send("\r\n" + stop);
  EXPECT_TRUE(eventually([&] { return status()["state"] == "disarmed"; }));
}

TEST_F(TunnelLimits, OneClientTooManyIsRefusedAndTheOthersStay) {
  TunnelProcess tunnel(home_, variables(play_));
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < kMaxTunnelClients; ++i) {
    clients.push_back(std::make_unique<RawClient>(tunnel.port()));
    ASSERT_TRUE(clients.back()->call("ping").contains("time_ns")) << i;
  }
  RawClient further(tunnel.port());
  EXPECT_THAT(further.response()["error"]["message"].get<std::string>(),
              HasSubstr("there are 32 clients already"));
  EXPECT_TRUE(further.closed_by_daemon());
  EXPECT_TRUE(clients.front()->call("ping").contains("time_ns"));
  clients.pop_back();
  EXPECT_TRUE(eventually([&] { return ctl({"status"}, tunnel.variables()).exit_code == 0; }));
}

TEST_F(TunnelLimits, AClientThatDoesNotReadCostsNoMemoryAndCanStillStop) {
  daemon_.reset();
  home_.configure(R"({"http": {"listen": null}, "connections": {"write_timeout_s": 600}})");
  start("tls://127.0.0.1:0");
  auto environment = variables(play_);
  environment.push_back(small_quarantine());
  TunnelProcess tunnel(home_, environment);
  RawClient game(tunnel.port());
  ASSERT_EQ(game.call("hello")["role"], "play");
  const int before_kb = peak_kb(tunnel.program());
  std::string all = many_requests();
  all += R"({"jsonrpc":"2.0","id":8,"method":"device.emergency_stop"})"
         "\n";
  ASSERT_TRUE(game.send(all));
  EXPECT_TRUE(eventually([&] { return status()["state"] == "disarmed"; }));
  EXPECT_LT(peak_kb(tunnel.program()) - before_kb, 4096) << "20 MB are not kept";
  int described = 0;
  bool stopped = false;
  while (described < kManyRequests || !stopped) {
    const auto line = game.line();
    ASSERT_TRUE(line) << "closed after " << described << " responses";
    if (line->find("\"id\":8") != std::string::npos)
      stopped = true;
    else if (line->find("\"id\":7,\"result\"") != std::string::npos)
      ++described;
  }
  EXPECT_LT(peak_kb(tunnel.program()) - before_kb, 4096);
}

}  // namespace
}  // namespace hedgehog::e2e
