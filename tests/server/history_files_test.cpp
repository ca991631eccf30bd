// SPDX-License-Identifier: MIT
// The event history on a real disk, and its format of the time of day.
#include "daemon/server/history/history_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "base/wall_time.h"
#include "tests/temporary_folder.h"

namespace hedgehog::server {
namespace {

class HistoryFiles : public testing::Test {
 protected:
  /// Writes `lines`; returns the error, or an empty string.
  std::string write(HistoryPart part, const std::string& lines, bool begin_file = false) {
    DiskWorkPtr work;
    {
      DiskThread disk;
      work = history_writer(folder_, disk)(part, lines, begin_file);
    }
    return work->problem;
  }
  const HistoryText& text(HistoryPart part) {
    texts_ = load_history(folder_);
    return texts_[static_cast<std::size_t>(part)];
  }
  TemporaryFolder temporary_;
  const std::string& folder_ = temporary_.path();
  HistoryTexts texts_;
};

TEST_F(HistoryFiles, AreAppendedToAndRotated) {
  EXPECT_EQ(write(HistoryPart::kBall, "one\n"), "");
  EXPECT_EQ(write(HistoryPart::kBall, "two\n"), "");
  EXPECT_EQ(write(HistoryPart::kBall, "three\n", true), "");
  EXPECT_EQ(write(HistoryPart::kEffects, "four\n", true), "");
  EXPECT_EQ(text(HistoryPart::kBall).full, "one\ntwo\n");
  EXPECT_EQ(text(HistoryPart::kBall).filling, "three\n");
  EXPECT_EQ(text(HistoryPart::kEffects).full, "");
  EXPECT_EQ(text(HistoryPart::kEffects).filling, "four\n");
}

TEST_F(HistoryFiles, NothingIsAppendedToAPartialLine) {
  EXPECT_EQ(write(HistoryPart::kTrips, R"({"at":"2026)"), "");
  EXPECT_EQ(write(HistoryPart::kTrips, "two\n"), "");
  EXPECT_EQ(text(HistoryPart::kTrips).filling, "{\"at\":\"2026\ntwo\n");
}

TEST_F(HistoryFiles, AFailedAppendLeavesNothingAndRotatesOnlyOnce) {
  const std::string much(500'000, 'x');  // larger than the limit of a log on stdout
  EXPECT_EQ(write(HistoryPart::kTrips, much + "\n"), "");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto limit = [&](rlim_t bytes) {
    const rlimit file{bytes, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &file), 0);
  };
  limit(500'010);
  EXPECT_NE(write(HistoryPart::kTrips, "a line of more than ten\n"), "");
  EXPECT_NE(write(HistoryPart::kTrips, much + much, true), "") << "the new file has no room either";
  limit(before.rlim_cur);
  EXPECT_EQ(write(HistoryPart::kTrips, "two\n", true), "");
  EXPECT_EQ(text(HistoryPart::kTrips).full, much + "\n");
  EXPECT_EQ(text(HistoryPart::kTrips).filling, "two\n");
}

TEST_F(HistoryFiles, AreNeitherReadNorWrittenIfNotRegular) {
  ASSERT_EQ(::mkfifo(temporary_.path("trips.jsonl").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo(temporary_.path("effects.jsonl.1").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", temporary_.path("events.jsonl"));
  EXPECT_EQ(text(HistoryPart::kTrips).filling, "");
  EXPECT_EQ(text(HistoryPart::kEffects).full, "");
  EXPECT_EQ(text(HistoryPart::kBall).filling, "");
  EXPECT_EQ(write(HistoryPart::kTrips, "one\n"),
            temporary_.path("trips.jsonl") + ": is a FIFO, not a regular file");
  EXPECT_EQ(write(HistoryPart::kBall, "one\n"),
            temporary_.path("events.jsonl") + ": is a device, not a regular file");
  EXPECT_EQ(write(HistoryPart::kEffects, "one\n"), "") << "beside it";
}

TEST(WallTime, IsRfc3339BothWays) {
  using base::parse_rfc3339;
  using base::rfc3339;
  EXPECT_EQ(base::rfc3339(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(base::rfc3339(1'795'216'447'412), "2026-11-20T23:14:07.412Z");
  for (const std::int64_t ms : {0LL, 951'782'400'000LL, 1'795'216'447'412LL})
    EXPECT_EQ(base::parse_rfc3339(base::rfc3339(ms)), ms);
  EXPECT_EQ(base::parse_rfc3339("2026-11-21T00:14:07.4129+01:00"), 1'795'216'447'412);
  EXPECT_EQ(base::parse_rfc3339("2026-11-20 23:14:07z"), 1'795'216'447'000);
  for (const char* wrong : {"", "yesterday", "2026-11-21", "2026-02-30T00:00:00Z",
                            "2026-11-21T24:00:00Z", "2026-11-21T01:14:07", "2026-11-21T01:14:07ZZ",
                            "2026-11-21T01:14:07.Z", "2026-11-21T01:14:07+25:00"})
    EXPECT_EQ(base::parse_rfc3339(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace hedgehog::server
