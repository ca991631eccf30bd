// SPDX-License-Identifier: MIT
#include "access/token_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/temporary_folder.h"

namespace hedgehog::access {
namespace {

const Tokens kTwo{{"arcade", protocol::Role::kPlay, digest_of("one"), "2026-11-24"},
                  {"lab.1", protocol::Role::kOperate, digest_of("two"), "2026-11-25"}};

TEST(TokenFile, ReadsWhatItWrites) {
  const auto read = parse_tokens(to_text(kTwo));
  ASSERT_TRUE(read) << read.error().reason;
  EXPECT_EQ(*read, kTwo);
}

TEST(TokenFile, HasDigestsAndNoTokens) {
  const std::string token = new_token();
  const std::string text =
      to_text({{"arcade", protocol::Role::kPlay, digest_of(token), "2026-11-24"}});
  EXPECT_THAT(text,
              testing::HasSubstr("arcade play sha256:" + base::to_hex(digest_of(token).bytes)));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr(token)));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr(token.substr(4))));
}

TEST(TokenFile, CommentsEmptyLinesAndLineEndsOfOtherSystemsAreSkipped) {
  const std::string digest = "sha256:" + base::to_hex(digest_of("x").bytes);
  const auto read = parse_tokens("# by hand\r\n\n  a  observe\t" + digest +
                                 " 2026-01-01\r\n\t\nb play " + digest + " 2026-01-02");
  ASSERT_TRUE(read) << read.error().reason;
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].made, "2026-01-01");
  EXPECT_EQ((*read)[1].role, protocol::Role::kPlay);
}

TEST(TokenFile, AnErrorNamesItsLineAndDoesNotQuoteIt) {
  const std::string good = "a play sha256:" + base::to_hex(digest_of("x").bytes) + " 2026-01-01\n";
  const std::string secret = new_token();
  for (const std::string& wrong :
       {"b play " + secret, std::string("b"),
        "b master sha256:" + base::to_hex(digest_of("y").bytes),
        "b play sha256:" + base::to_hex(digest_of("y").bytes) + " 2026-01-01 more",
        std::string("b play sha256:00 2026-01-01")}) {
    const auto read = parse_tokens(good + "\n" + wrong + "\n");
    ASSERT_FALSE(read) << wrong;
    EXPECT_EQ(read.error().line, 3) << wrong;
    EXPECT_THAT(read.error().reason, testing::Not(testing::HasSubstr(secret)));
  }
  const auto twice = parse_tokens(good + good);
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().line, 2);
}

TEST(TokenFile, IsBounded) {
  std::string text;
  for (std::size_t i = 0; i <= kMaxTokens; ++i)
    text += "t" + std::to_string(i) +
            " play sha256:" + base::to_hex(digest_of(std::to_string(i)).bytes) + " 2026-01-01\n";
  EXPECT_FALSE(parse_tokens(text));
  text.erase(text.rfind("t" + std::to_string(kMaxTokens)));
  EXPECT_TRUE(parse_tokens(text));
}

TEST(TokenFile, IsReadableByItsOwnerOnlyWhateverTheUmask) {
  const TemporaryFolder folder;
  const std::string path = folder.path("tokens");
  const mode_t before = ::umask(0);
  EXPECT_EQ(write_secret_file(path, to_text(kTwo)), "");
  ::umask(before);
  struct stat info {};
  ASSERT_EQ(::stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0600u);
  const auto read = read_tokens(path);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, kTwo);
}

TEST(TokenFile, WrittenByRootBelongsToTheOwnerOfTheFolder) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root writes into folders of others";
  const TemporaryFolder folder;
  constexpr uid_t kDaemon = 12345;
  ASSERT_EQ(::chown(folder.path().c_str(), kDaemon, kDaemon), 0);
  ASSERT_EQ(write_secret_file(folder.path("tokens"), to_text(kTwo)), "");
  struct stat info {};
  ASSERT_EQ(::stat(folder.path("tokens").c_str(), &info), 0);
  EXPECT_EQ(info.st_uid, kDaemon);
  EXPECT_EQ(info.st_gid, kDaemon);
}

TEST(TokenFile, AMissingFileHasNoTokensAndAFolderIsAnError) {
  const TemporaryFolder folder;
  const auto none = read_tokens(folder.path("tokens"));
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->empty());
  EXPECT_FALSE(read_tokens(folder.path()));
  EXPECT_NE(write_secret_file(folder.path("no/such/tokens"), ""), "");
}

}  // namespace
}  // namespace hedgehog::access
