// SPDX-License-Identifier: MIT
// Listeners reachable from other machines need tokens and a certificate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "access/certificate.h"
#include "access/token_file.h"
#include "tests/config/fake_files.h"

namespace hedgehog::config {
namespace {

const std::string kConfigFile = "/etc/hedgehog/hedgehogd.json";
const std::string kTokens = "/var/lib/hedgehog/tokens";
const std::string kCertificate = "/var/lib/hedgehog/certificate.pem";
const std::string kKey = "/var/lib/hedgehog/key.pem";

std::string listens_at(const std::string& address) {
  return "{\"listen\": {\n\"tcp\": [\"" + address + "\"]}}";
}

FakeFiles with_files(const std::string& address) {
  FakeFiles fake = FakeFiles::with(listens_at(address));
  const access::Certificate made = access::new_certificate("ball-host", 1);
  fake.files[kTokens] = access::to_text(
      {{"arcade", protocol::Role::kPlay, access::digest_of("secret"), "2026-11-24"}});
  fake.files[kCertificate] = made.certificate_pem;
  fake.files[kKey] = made.key_pem;
  return fake;
}

TEST(ConfigAccess, RemotelyReachableAddressesAreRefusedWithoutTheFiles) {
  for (const std::string address : {"0.0.0.0:7586", "192.168.1.5:7586", "[::]:7586", "128.0.0.1:1",
                                    "tls://127.0.0.1:7586", "tls://0.0.0.0:7586"}) {
    const std::string shown = address.starts_with("tls://") ? address : "tls://" + address;
    const std::string begin = kConfigFile + ":2: listen.tcp: " + shown +
                              ": refused, because other machines could reach it and there is no ";
    FakeFiles fake = FakeFiles::with(listens_at(address));
    EXPECT_EQ(fake.errors(), begin + kTokens +
                                 "; make it: hedgehogctl token add NAME --role play --state "
                                 "/var/lib/hedgehog\n" +
                                 begin + kCertificate +
                                 "; make it: hedgehogctl token certificate --state "
                                 "/var/lib/hedgehog\n");
    EXPECT_EQ(with_files(address).errors(), "");
  }
  EXPECT_THAT(FakeFiles::with(R"({"http": {"listen": "0.0.0.0:7587"}})").errors(),
              testing::HasSubstr("http.listen: tls://0.0.0.0:7587: refused"));
}

TEST(ConfigAccess, EachOfTheFilesIsNeeded) {
  for (const std::string& missing : {kTokens, kCertificate, kKey}) {
    FakeFiles fake = with_files("0.0.0.0:7586");
    fake.files.erase(missing);
    EXPECT_THAT(fake.errors(), testing::HasSubstr("there is no " + missing)) << missing;
  }
}

TEST(ConfigAccess, AKeyOfAnotherCertificateIsAnError) {
  FakeFiles fake = with_files("0.0.0.0:7586");
  fake.files[kKey] = access::new_certificate("ball-host", 1).key_pem;
  EXPECT_EQ(fake.errors(),
            kCertificate + ": the key is that of another certificate (" + kKey + ")\n");
}

TEST(ConfigAccess, AnInvalidTokenFileIsAnErrorForEveryListener) {
  FakeFiles fake = with_files("127.0.0.1:7586");
  fake.files[kTokens] += "arcade\n";
  EXPECT_THAT(fake.errors(), testing::StartsWith(kTokens + ":3: must be NAME ROLE"));
}

TEST(ConfigAccess, AFileWithoutTokensIsValidAndRefusesEveryClient) {
  FakeFiles fake = with_files("0.0.0.0:7586");
  fake.files[kTokens] = "# all revoked\n";
  EXPECT_EQ(fake.errors(), "");
}

TEST(ConfigAccess, ThePathsOfTheFilesAreConfigurable) {
  FakeFiles fake = with_files("0.0.0.0:7586");
  for (const auto& [from, to] :
       {std::pair{kTokens, "/a/t"}, std::pair{kCertificate, "/a/c"}, std::pair{kKey, "/a/k"}}) {
    fake.files[to] = fake.files[from];
    fake.files.erase(from);
  }
  fake.files[kConfigFile] = R"({"listen": {"tcp": ["0.0.0.0:7586"]},
      "access": {"tokens": "/a/t", "certificate": "/a/c", "key": "/a/k"}})";
  EXPECT_EQ(fake.errors(), "");
  ASSERT_EQ(fake.load()->access.tokens.size(), 1u);
}

TEST(ConfigAccess, ThePrintedConfigurationHasPathsAndNoSecrets) {
  const FakeFiles fake = with_files("0.0.0.0:7586");
  const auto config = fake.load();
  ASSERT_TRUE(config);
  const std::string printed = print_config(*config);
  EXPECT_THAT(printed, testing::HasSubstr(kTokens));
  EXPECT_THAT(printed, testing::HasSubstr("tls://0.0.0.0:7586"));
  EXPECT_THAT(printed, testing::Not(testing::HasSubstr("PRIVATE KEY")));
  EXPECT_THAT(printed,
              testing::Not(testing::HasSubstr(base::to_hex(access::digest_of("secret").bytes))));
}

FakeFiles with_unix(const std::string& lists) {
  return FakeFiles::with("{\"access\": {\"unix\": {\n" + lists + "}}}");
}

TEST(ConfigAccess, UsersOfTheUnixSocketOperateUnlessListedOtherwise) {
  EXPECT_EQ(FakeFiles{}.load()->access.unix_roles, access::UnixRoles{});
  const FakeFiles fake = with_unix(R"("operate": ["@root"], "play": ["daemon"], "observe": ["*"])");
  ASSERT_EQ(fake.errors(), "");
  const access::UnixRoles roles = fake.load()->access.unix_roles;
  ASSERT_EQ(roles.play.size(), 1u);
  EXPECT_EQ(roles.play[0].id, 1u) << "by the system's list of users";
  EXPECT_FALSE(access::has_everybody(roles.operate));
  EXPECT_THAT(print_config(*fake.load()), testing::HasSubstr("\"@root\""));
  EXPECT_EQ(with_unix(R"("operate": [])").errors(), "") << "root and the daemon's own user only";
}

TEST(ConfigAccess, AUserOrGroupThatDoesNotExistIsAnError) {
  EXPECT_EQ(
      with_unix(R"("operate": ["root", "no-such-user-here"])").errors(),
      kConfigFile + ":2: access.unix.operate: \"no-such-user-here\": there is no such user\n");
  EXPECT_EQ(
      with_unix(R"("operate": [], "play": ["@no-such-group-here"])").errors(),
      kConfigFile + ":2: access.unix.play: \"@no-such-group-here\": there is no such group\n");
  for (const std::string list : {R"("root")", "[0]", "null"})
    EXPECT_THAT(with_unix("\"operate\": " + list).errors(),
                testing::HasSubstr("access.unix.operate: must be a list of users and groups"))
        << list;
}

TEST(ConfigAccess, AListBelowThatOfAllUsersIsAnError) {
  EXPECT_EQ(with_unix(R"("play": ["daemon"])").errors(),
            kConfigFile +
                ":2: access.unix.play: has no effect, because access.unix.operate has "
                "\"*\"; list the permitted users there instead\n");
  EXPECT_THAT(with_unix(R"("operate": [], "play": ["*"], "observe": ["root"])").errors(),
              testing::HasSubstr("access.unix.observe: has no effect, because access.unix.play"));
  EXPECT_EQ(with_unix(R"("operate": [], "play": ["*"])").errors(), "");
}

}  // namespace
}  // namespace hedgehog::config
