// SPDX-License-Identifier: MIT
// The exit codes of hedgehogctl agree with its help and its README.
#include "clients/ctl/exit_code.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "clients/ctl/command_line.h"
#include "tests/folders.h"

namespace hedgehog::client {
namespace {

ExitCode refused(protocol::ErrorCode code) {
  ClientError error{Failure::kRefused, "no", protocol::RpcError{.code = code, .message = "no"}};
  return exit_code_of(error);
}

ExitCode failed(Failure failure) { return exit_code_of(ClientError{failure, "no", {}}); }

TEST(ExitCode, DistinguishesUsageTemporaryAndOtherErrors) {
  using enum protocol::ErrorCode;
  EXPECT_EQ(refused(kInvalidParams), 64);
  EXPECT_EQ(refused(kNoSuchPattern), 66);
  EXPECT_EQ(refused(kNoSuchEffect), 1);
  EXPECT_EQ(refused(kNotArmed), 69);
  EXPECT_EQ(refused(kDeviceAbsent), 69);
  EXPECT_EQ(refused(kInternalError), 70);
  for (const auto code : {kBusy, kRefusedThermal, kClaimed, kArmed}) EXPECT_EQ(refused(code), 75);
  for (const auto code : {kParseError, kInvalidRequest, kMethodNotFound, kUnsupported})
    EXPECT_EQ(refused(code), 76);
  for (const auto code : {kUnauthorized, kForbidden}) EXPECT_EQ(refused(code), 77);
  EXPECT_EQ(failed(Failure::kBadAddress), 64);
  EXPECT_EQ(failed(Failure::kBadData), 65);
  EXPECT_EQ(failed(Failure::kNoInput), 66);
  EXPECT_EQ(failed(Failure::kNoDaemon), 69);
  EXPECT_EQ(failed(Failure::kClosed), 69);
  EXPECT_EQ(failed(Failure::kTimeout), 75);
  EXPECT_EQ(failed(Failure::kProtocol), 76);
}

/// The numbers before the words of a list such as "0 done, 64 usage" or "0 done · 64 usage".
std::set<int> codes_of(const std::string& list) {
  static const std::regex code(R"((?:^|,|·|: )\s*(\d+)\s+[a-z])");
  std::set<int> found;
  for (std::sregex_iterator at(list.begin(), list.end(), code), end; at != end; ++at)
    found.insert(std::stoi((*at)[1]));
  return found;
}

TEST(ExitCode, AllAreInTheHelpAndInTheReadme) {
  const std::set<int> all{kDone,     kEndedOtherwise, kUsage,      kBadData,
                          kNoInput,  kUnavailable,    kInternal,   kCannotCreate,
                          kTryLater, kProtocolError,  kNotAllowed, kInterrupted};
  std::string name = "hedgehogctl";
  std::string option = "--help";
  std::vector<char*> argv{name.data(), option.data()};
  testing::internal::CaptureStdout();
  run_command_line(static_cast<int>(argv.size()), argv.data());
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_EQ(codes_of(help.substr(help.find("Exit: "))), all);
  std::ifstream file(source_folder() + "/clients/ctl/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const auto begin = readme.find("Exit codes: ");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(codes_of(readme.substr(begin, readme.find("`check` has its own") - begin)), all);
}

}  // namespace
}  // namespace hedgehog::client
