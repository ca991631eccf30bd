// SPDX-License-Identifier: MIT
// `hedgehogctl board flash` against a daemon whose board reports another firmware afterwards.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "clients/ctl/board/flash_verb.h"
#include "protocol/server_codec.h"
#include "tests/clients/fake_daemon.h"
#include "tests/clients/uf2_sample.h"
#include "tests/temporary_folder.h"

namespace hedgehog::client {
namespace {

using protocol::Id;
using testing::HasSubstr;

/// Returns one response after the other.
class ScriptedResponses {
 public:
  explicit ScriptedResponses(FakePeer& peer) : peer_(peer) {}
  template <class Value>
  std::string give(const Value& value) {
    const std::string request = peer_.read();
    peer_.send_line(protocol::encode_result(Id::number(++id_), value));
    return request;
  }

 private:
  FakePeer& peer_;
  int id_ = 0;
};

protocol::Description board(bool present, const char* firmware) {
  protocol::Description description;
  description.board.backend = "usb";
  description.board.present = present;
  if (present) description.board.firmware = firmware;
  if (present) description.board.protocol = "1.2";
  return description;
}

protocol::Status status(const char* state) {
  protocol::Status status;
  status.state = state;
  status.remedy = "Run: hedgehogctl arm";
  return status;
}

struct BoardFlash : testing::Test {
  TemporaryFolder folder;
  FlashOptions options;

  void SetUp() override {
    folder.write("new.uf2", Uf2Sample::pages(2).text());
    std::filesystem::create_directory(folder.path("RPI-RP2"));
    folder.write("RPI-RP2/INFO_UF2.TXT", "Board-ID: RPI-RP2\r\n");
    options.file = folder.path("new.uf2");
    options.volume = folder.path("RPI-RP2");
  }
  int flash(const FakeDaemon& daemon, bool json) {
    CommonOptions common;
    common.address = "127.0.0.1:" + std::to_string(daemon.address().port);
    common.json = json;
    return run_board_flash(common, options);
  }
};

TEST_F(BoardFlash, PrintsTheFirmwareBeforeAndAfter) {
  std::string request;
  FakeDaemon daemon([&](FakePeer& peer) {
    ScriptedResponses responses(peer);
    responses.give(protocol::HelloResult{});
    responses.give(board(true, "1.02"));
    responses.give(status("disarmed"));
    request = responses.give(protocol::StateResult{"absent", "boot_loader", {}, 7});
    responses.give(board(false, ""));
    responses.give(board(true, "1.03"));
    responses.give(status("disarmed"));
  });
  testing::internal::CaptureStdout();
  EXPECT_EQ(flash(daemon, false), kDone);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "  file      " + options.file +
                                                        ": 2 blocks, 512 bytes below 0x10000200\n" +
                                                        "  board     is in its boot loader\n"
                                                        "  written   to " +
                                                        options.volume +
                                                        "\n"
                                                        "  firmware  1.02 → 1.03\n"
                                                        "  protocol  1.2 → 1.2\n"
                                                        "  disarmed  Run: hedgehogctl arm\n");
  daemon.finish();
  EXPECT_THAT(request, HasSubstr("device.enter_boot_loader"));
  EXPECT_EQ(folder.read("RPI-RP2/hedgehog.uf2"), Uf2Sample::pages(2).text());
}

TEST_F(BoardFlash, ABoardAlreadyInItsBootLoaderGetsNoRequest) {
  FakeDaemon daemon([&](FakePeer& peer) {
    ScriptedResponses responses(peer);
    responses.give(protocol::HelloResult{});
    responses.give(board(false, ""));
    responses.give(status("absent"));
    responses.give(board(true, "1.03"));
    responses.give(status("disarmed"));
  });
  testing::internal::CaptureStdout();
  EXPECT_EQ(flash(daemon, true), kDone);
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            R"({"file":")" + options.file + R"(","blocks":2,"bytes":512,"written_by":"volume",)" +
                R"("volume":")" + options.volume +
                R"(","firmware":{"before":null,"after":"1.03"},)"
                R"("protocol":{"before":null,"after":"1.2"},)"
                R"("state":"disarmed","remedy":"Run: hedgehogctl arm"})"
                "\n");
}

TEST_F(BoardFlash, ABoardThatDoesNotReturnIsAFailure) {
  options.wait_s = 0.0;
  FakeDaemon daemon([&](FakePeer& peer) {
    ScriptedResponses responses(peer);
    responses.give(protocol::HelloResult{});
    responses.give(board(true, "1.02"));
    responses.give(status("disarmed"));
    responses.give(protocol::StateResult{"absent", "boot_loader", {}, 7});
    responses.give(board(false, ""));
    auto absent = status("absent");
    absent.remedy = "Plug in the ball";
    responses.give(absent);
  });
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(flash(daemon, false), kUnavailable);
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "hedgehogctl: the daemon does not see the board again. Plug in the ball\n");
}

}  // namespace
}  // namespace hedgehog::client
