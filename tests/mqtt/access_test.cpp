// SPDX-License-Identifier: MIT
// A broker that accepts clients only with a password, and only over TLS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"
#include "tests/free_port.h"
#include "tests/mqtt/mosquitto.h"

namespace hedgehog::e2e {
namespace {

using testing::HasSubstr;
using testing::Not;

void run(const Home& home, const std::string& path, const std::vector<std::string>& arguments) {
  Program program(home, path, arguments);
  const Ended ended = program.wait();
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
}

std::string with_password(const Home& home) {
  run(home, "/usr/bin/mosquitto_passwd", {"-c", "-b", home.path("passwords"), "ball", "secret"});
  return "allow_anonymous false\npassword_file " + home.path("passwords") + "\n";
}

TEST(MqttAccess, IsByUserAndAHiddenPassword) {
  const Home home;
  const Mosquitto broker(home, with_password(home));
  const DaemonProcess daemon(home);
  home.write("right", "secret\n");
  home.write("wrong", "guess\n");
  const std::vector<std::string> arguments{"--address",      daemon.socket(), "--broker",
                                           broker.socket(),  "--user",        "ball",
                                           "--password-file"};
  auto with = [&](const std::string& file) {
    auto all = arguments;
    all.push_back(home.path(file));
    return all;
  };
  Program refused(home, hedgehog_mqtt(), with("wrong"));
  ASSERT_TRUE(eventually([&] { return refused.err().find("Not authorized") != std::string::npos; }))
      << refused.err();
  EXPECT_THAT(refused.err(), Not(HasSubstr("guess")));
  refused.signal(SIGTERM);
  EXPECT_EQ(refused.wait().exit_code, 130);
  const Program admitted(home, hedgehog_mqtt(), with("right"));
  EXPECT_TRUE(eventually(
      [&] { return admitted.err().find("connected to the broker") != std::string::npos; }));
}

TEST(MqttAccess, OverTlsVerifiesTheBrokersCertificate) {
  const Home home;
  for (const char* name : {"broker", "other"})
    run(home, "/usr/bin/openssl",
        {"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost",
         "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1", "-keyout",
         home.path(std::string(name) + ".key"), "-out", home.path(std::string(name) + ".pem")});
  const std::string port = std::to_string(free_port());
  const Mosquitto broker(home, "allow_anonymous true\nlistener " + port + " 127.0.0.1\ncertfile " +
                                   home.path("broker.pem") + "\nkeyfile " +
                                   home.path("broker.key") + "\ntls_version tlsv1.3\n");
  const DaemonProcess daemon(home);
  auto with = [&](const std::string& certificates) {
    return std::vector<std::string>{"--address", daemon.socket(),
                                    "--broker",  "mqtts://localhost:" + port,
                                    "--ca-file", home.path(certificates)};
  };
  const Program admitted(home, hedgehog_mqtt(), with("broker.pem"));
  EXPECT_TRUE(eventually([&] {
    return admitted.err().find("connected to the broker") != std::string::npos;
  })) << admitted.err();
  const Program other_ca(home, hedgehog_mqtt(), with("other.pem"));
  EXPECT_TRUE(eventually([&] {
    return other_ca.err().find("no broker at localhost") != std::string::npos;
  })) << other_ca.err();
  EXPECT_THAT(other_ca.err(), Not(HasSubstr("connected to the broker")));
  Program none(home, hedgehog_mqtt(), with("missing.pem"));
  EXPECT_EQ(none.wait().exit_code, 66);
}

}  // namespace
}  // namespace hedgehog::e2e
