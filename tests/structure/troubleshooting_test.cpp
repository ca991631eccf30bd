// SPDX-License-Identifier: MIT
// Messages of this checkout and the pages that explain them, in both directions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/folders.h"
#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

using testing::IsEmpty;

constexpr const char* kOfDaemon = "daemon/troubleshooting.md";
constexpr const char* kOfClients = "clients/troubleshooting.md";
constexpr const char* kOfStudy = "clients/study/troubleshooting.md";

/// Of hedgehogctl's other verbs, hedgehog-racer, hedgehog-orientation and hedgehog-design a message
/// names its remedy itself, or the mistake in an option. The same holds for mistakes in a
/// configuration or an experiment's file, which are printed with file, line and key.
std::vector<ProgramMessages> programs() {
  return {
      {"daemon/",
       {"spdlog::warn(", "spdlog::error(", "runtime_error(", "sentences.push_back(", "Refusal(",
        "problem_ = folder"},
       kOfDaemon,
       {{"refused: other machines could reach it without TLS",
         "the configuration is refused before"},
        {"refused: there is no certificate", "the configuration is refused before"}}},
      {"clients/lib/",
       {"ClientError(", "return {Failure::", "fail_attempt(", "not_found("},
       kOfClients,
       {}},
      {"clients/ctl/tunnel/",
       {"Failure::kNoDaemon, ", "Failure::kProtocol, ", "Failure::kClosed, ", "message += "},
       kOfClients,
       {{"there is no address", "one of the addresses has failed, or there is no ball"}}},
      {"clients/mqtt/",
       {"Problem(", "report_once(", "ClientError(", "protocol::error(", "protocol::busy("},
       kOfClients,
       {{"connected to … as ", "is no error"}}},
      {"clients/gamepad/",
       {"Problem(", "report_once(", "message += "},
       kOfClients,
       {{"connected to …, the ball is …", "is no error"}}},
      {"clients/study/",
       {"Problem(", "report_error(", "ClientError(", "fprintf(stderr", "cannot(",
        "problems.push_back(", "stuck_reason_ = "},
       kOfStudy,
       {{"hedgehog-study: %s", "what every message begins with"}}},
  };
}

class Troubleshooting : public testing::Test {
 protected:
  static const SourceTree& tree() {
    static const SourceTree kTree = read_tree(source_folder());
    return kTree;
  }

  /// REQUIRES: there is such a file.
  static const SourceFile& file_at(const std::string& path) {
    const auto& files = tree().files;
    return *std::find_if(files.begin(), files.end(),
                         [&](const SourceFile& one) { return one.path == path; });
  }
};

TEST_F(Troubleshooting, QuotesPrintedMessages) {
  for (const char* page : {kOfDaemon, kOfClients, kOfStudy})
    EXPECT_THAT(check_quoted_messages(file_at(page), tree()), IsEmpty());
}

TEST_F(Troubleshooting, ExplainsEachWarningAndError) {
  for (const ProgramMessages& program : programs())
    EXPECT_THAT(check_explained_messages(program, tree()), IsEmpty());
}

TEST_F(Troubleshooting, ExplainsEachErrorOfTheProtocol) {
  EXPECT_THAT(check_explained_errors(file_at("protocol/wire/error.cpp"), file_at(kOfClients)),
              IsEmpty());
}

}  // namespace
}  // namespace hedgehog::structure
