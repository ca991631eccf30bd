// SPDX-License-Identifier: MIT
// What scanners of TLS servers check, tried by openssl's own client at both ports with TLS: old
// protocols, renegotiation, weak ciphers, resumption, early data. Each test prints its commands
// with their output. Where the daemon rejects, openssl's own server, which accepts, is the control.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <iostream>
#include <string>
#include <vector>

#include "tests/e2e/raw_client.h"
#include "tests/e2e/tls_fixture.h"

namespace hedgehog::e2e {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

const std::string kOpenssl = "/usr/bin/openssl";

class TlsChecks : public TlsFixture {
 protected:
  /// Output of openssl's client at `port`; `input`: its standard input, as a format of printf.
  std::string s_client(int port, const std::string& options, const std::string& input = "") {
    const std::string command = "openssl s_client -connect 127.0.0.1:" + std::to_string(port) +
                                (options.empty() ? "" : " " + options);
    std::string out =
        Program(home_, "/bin/sh", {"-c", "printf '" + input + "' | " + command + " 2>&1"})
            .wait()
            .out;
    std::cout << "$ printf '" << input << "' | " << command << "\n" << out << std::endl;
    return out;
  }
  std::vector<int> ports() const { return {port("tls://"), port("https://")}; }

  const std::vector<std::string> words_{"--listen", "tls://127.0.0.1:0"};
  const DaemonProcess daemon_{home_, words_};
};

/// openssl's own server with the daemon's certificate, which also has TLS 1.2, renegotiation,
/// tickets and early data.
class PermissiveServer {
 public:
  explicit PermissiveServer(const Home& home) : server_(home, "/bin/sh", {"-c", command(home)}) {
    const std::string line = "ACCEPT 127.0.0.1:";
    const bool listens = eventually([&] {
      const std::string out = server_.out();
      const auto at = out.find(line);
      if (at == std::string::npos || out.find('\n', at) == std::string::npos) return false;
      port_ = std::stoi(out.substr(at + line.size()));
      return true;
    });
    EXPECT_TRUE(listens) << server_.err();
  }
  int port() const noexcept { return port_; }

 private:
  static std::string command(const Home& home) {
    // It exits at the end of its input, so its input is a pipe that stays open.
    ::mkfifo(home.path("keyboard").c_str(), 0600);
    return "exec openssl s_server -accept 127.0.0.1:0 -cert " +
           home.path("state/hedgehog/certificate.pem") + " -key " +
           home.path("state/hedgehog/key.pem") +
           " -early_data -max_early_data 16384 -no_anti_replay -client_renegotiation 0<>" +
           home.path("keyboard");
  }

  Program server_;
  int port_ = 0;
};

TEST_F(TlsChecks, OldProtocolsAreRefusedByTheDaemon) {
  const PermissiveServer permissive(home_);
  EXPECT_THAT(s_client(permissive.port(), "-tls1_2"), HasSubstr("New, TLSv1.2"));
  for (const int port : ports()) {
    for (const std::string version :
         {"-tls1_2", "-tls1_1 -cipher DEFAULT@SECLEVEL=0", "-tls1 -cipher DEFAULT@SECLEVEL=0"}) {
      const std::string output = s_client(port, version);
      EXPECT_THAT(output, HasSubstr("alert protocol version"));
      EXPECT_THAT(output, HasSubstr("Cipher is (NONE)"));
    }
    EXPECT_THAT(s_client(port, ""), HasSubstr("New, TLSv1.3"));
  }
}

TEST_F(TlsChecks, OnlyStrongCiphers) {
  for (const int port : ports()) {
    const std::string output = s_client(port, "");
    EXPECT_THAT(output, AnyOf(HasSubstr("Cipher is TLS_AES_256_GCM_SHA384"),
                              HasSubstr("Cipher is TLS_CHACHA20_POLY1305_SHA256"),
                              HasSubstr("Cipher is TLS_AES_128_GCM_SHA256")));
    EXPECT_THAT(s_client(port, "-ciphersuites TLS_AES_128_CCM_8_SHA256"),
                HasSubstr("alert handshake failure"))
        << "a tag of 8 bytes";
  }
}

TEST_F(TlsChecks, ThereIsNoRenegotiation) {
  const PermissiveServer permissive(home_);
  const std::string control = s_client(permissive.port(), "-tls1_2", "R\\n");
  EXPECT_THAT(control, HasSubstr("RENEGOTIATING"));
  EXPECT_THAT(control, Not(HasSubstr("no renegotiation")));
  for (const int port : ports()) {
    const std::string output = s_client(port, "-legacy_renegotiation", "R\\n");
    EXPECT_THAT(output, HasSubstr("Secure Renegotiation IS NOT supported"));
    EXPECT_THAT(output, HasSubstr("wrong ssl version")) << "TLS 1.3 has none";
    EXPECT_THAT(s_client(port, "-tls1_2", "R\\n"), Not(HasSubstr("RENEGOTIATING")))
        << "and there is no older protocol to do it in";
  }
}

TEST_F(TlsChecks, EarlyDataIsRejectedAndNotExecuted) {
  const PermissiveServer permissive(home_);
  const std::string session = home_.path("permissive.pem");
  {
    Program first(home_, kOpenssl,
                  {"s_client", "-connect", "127.0.0.1:" + std::to_string(permissive.port()),
                   "-ign_eof", "-sess_out", session});
    ASSERT_TRUE(eventually([&] { return !home_.read("permissive.pem").empty(); })) << first.err();
  }
  // The first bytes of a recorded connection, replayed.
  home_.write("early", R"({"jsonrpc":"2.0","id":1,"method":"hello","params":{"token":")" +
                           operate_ + "\"}}\n" +
                           R"({"jsonrpc":"2.0","method":"device.emergency_stop"})" + "\n");
  const std::string replay = "-sess_in " + session + " -early_data " + home_.path("early");
  ASSERT_THAT(s_client(permissive.port(), replay), HasSubstr("Early data was accepted"));
  for (const int port : ports()) {
    const std::string output = s_client(port, replay);
    EXPECT_THAT(output, HasSubstr("New, TLSv1.3")) << "not the session of another server";
    EXPECT_THAT(output, HasSubstr("Early data was rejected"));
  }
  EXPECT_EQ(RawClient(daemon_.socket()).call("device.status")["state"], "armed");
  EXPECT_THAT(daemon_.log(), Not(HasSubstr("the token owner")));
}

TEST_F(TlsChecks, NoSessionCanBeResumed) {
  for (const int port : ports()) {
    const std::string file = "resumable-" + std::to_string(port);
    // The daemon closes at the x, which is neither a message nor an HTTP request.
    const std::string output = s_client(port, "-ign_eof -sess_out " + home_.path(file), "x\\n\\n");
    EXPECT_THAT(output, HasSubstr("New, TLSv1.3"));
    EXPECT_THAT(output, Not(HasSubstr("New Session Ticket")));
    EXPECT_EQ(home_.read(file), "");
  }
}

}  // namespace
}  // namespace hedgehog::e2e
