// SPDX-License-Identifier: MIT
// The device whose board is another process: what its host sees, and what that process receives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "daemon/device/board_core/crc32.h"
#include "emulator/firmware/firmware_board.h"
#include "tests/emulator/fake_host.h"
#include "tests/temporary_folder.h"

namespace hedgehog::emulator {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr Byte kPlug = 1;
constexpr Byte kUnplug = 2;
constexpr Byte kControl = 3;
constexpr Byte kRun = 4;
constexpr Byte kStatus = 5;

/// The process at the other end, with the responses that a test sets.
struct FakeProcess {
  Bytes message(Byte type, const Bytes& payload) const {
    Bytes bytes{'H', type, static_cast<Byte>(payload.size()),
                static_cast<Byte>(payload.size() >> 8)};
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    const std::uint32_t crc = board::crc32(bytes.data(), bytes.size()) + crc_error;
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<Byte>(crc >> 8 * i));
    return bytes;
  }

  void receive(std::span<const Byte> bytes) {
    ASSERT_GE(bytes.size(), 8U);
    const std::size_t length = device::little_u16(&bytes[2]);
    ASSERT_EQ(bytes.size(), length + 8);
    EXPECT_EQ(device::little_u32(&bytes[4 + length]), board::crc32(bytes.data(), 4 + length));
    const Byte type = bytes[1];
    requests.push_back(type);
    last[type] = Bytes(bytes.begin() + 4, bytes.begin() + 4 + static_cast<std::ptrdiff_t>(length));
    Bytes response = responses[type];
    if (type == kControl && descriptors.contains(last[type][3])) {
      response = {0};
      const std::string& text = descriptors[last[type][3]][last[type][2]];
      response.insert(response.end(), text.begin(), text.end());
    }
    const Bytes sent = message(error.empty() ? static_cast<Byte>(type | 0x80) : Byte{0xFF},
                               error.empty() ? response : Bytes(error.begin(), error.end()));
    if (!silent) pending.insert(pending.end(), sent.begin(), sent.end());
  }

  Bytes requests;
  std::map<Byte, Bytes> last;
  std::map<Byte, Bytes> responses{{kRun, {0, 0, 0}}, {kControl, {0}}};
  /// By type and index of the descriptor.
  std::map<Byte, std::map<Byte, std::string>> descriptors{
      {1, {{0, std::string("\x12\x01\0\x02\0\0\0\x40\x09\x12\x01\0\x02\x01\x01\x02\x03\x01", 18)}}},
      {2,
       {{0, std::string("\x09\x02\x20\0\x01\x01\0\xC0\x32"
                        "\x09\x04\0\0\x02\xFF\x48\x01\0"
                        "\x07\x05\x01\x02\x40\0\0\x07\x05\x81\x02\x40\0\0",
                        32)}}},
      {3, {{2, std::string("\x06\x03I\0\x42\0", 6)}, {3, std::string("\x06\x03S\0001\0", 6)}}},
  };
  std::string error;
  std::uint32_t crc_error = 0;
  bool silent = false;
  std::deque<Byte> pending;
};

class FakePort : public BytePort {
 public:
  explicit FakePort(FakeProcess& process) : process_(process) {}
  void write(std::span<const Byte> bytes) override { process_.receive(bytes); }
  std::optional<Byte> poll() override {
    if (process_.pending.empty()) return std::nullopt;
    const Byte byte = process_.pending.front();
    process_.pending.pop_front();
    return byte;
  }

 private:
  FakeProcess& process_;
};

class ForwardedBoard : public testing::Test {
 protected:
  void plug() { host_.emplace(board_); }

  FakeProcess process_;
  TemporaryFolder folder_;
  FirmwareBoard board_{std::make_unique<FakePort>(process_), folder_.path("trace")};
  std::optional<FakeHost> host_;
};

TEST_F(ForwardedBoard, IsExportedWithTheFirmwaresDescriptors) {
  EXPECT_EQ(process_.requests.front(), kPlug);
  EXPECT_EQ(process_.requests.back(), kUnplug);
  const Exported exported = board_.exported();
  EXPECT_EQ(exported.vendor, 0x1209);
  EXPECT_EQ(exported.product, 0x0001);
  EXPECT_EQ(exported.release, 0x0102);
  ASSERT_EQ(exported.interfaces.size(), 1U);
  EXPECT_EQ(exported.interfaces[0].subclass, 0x48);
  EXPECT_EQ(board_.product_name(), "IB");
  EXPECT_EQ(board_.serial(), "S1");
}

TEST_F(ForwardedBoard, RunsFromItsFirstPluggingOnAlsoUnplugged) {
  process_.requests.clear();
  board_.step();
  EXPECT_THAT(process_.requests, IsEmpty());
  plug();
  host_->run(1);
  host_.reset();
  board_.unplugged();
  board_.step();
  EXPECT_THAT(process_.requests, ElementsAre(kPlug, kRun, kUnplug, kRun));
}

TEST_F(ForwardedBoard, ExchangesPacketsOfTheBoardsMillisecond) {
  plug();
  EXPECT_EQ(host_->write(1, {7, 8}).status, 0);
  host_->submit(true, 1, 64);
  host_->submit(true, 1, 64);
  process_.responses[kRun] = {0, 0, 1, 3, 1, 2, 3};
  host_->run(1);
  EXPECT_THAT(process_.last[kRun], ElementsAre(2, 1, 2, 7, 8));
  EXPECT_THAT(host_->next(true)->data, ElementsAre(1, 2, 3));
  host_->run(1);
  EXPECT_THAT(process_.last[kRun], ElementsAre(1, 0)) << "one read is left";
}

TEST_F(ForwardedBoard, DoesNotAcknowledgeMoreThanTheBoardAccepts) {
  plug();
  process_.responses[kRun] = {0, 4, 0};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(host_->write(1, {1}).status, 0);
  host_->run(1);
  host_->submit(false, 1, 1, {5});
  EXPECT_FALSE(host_->next());
  process_.responses[kRun] = {0, 0, 0};
  host_->run(1);
  EXPECT_EQ(host_->next()->status, 0);
  host_->run(1);
  EXPECT_THAT(process_.last[kRun], ElementsAre(0, 1, 1, 5));
}

TEST_F(ForwardedBoard, StallsAsTheFirmwareDoesUntilTheHostClearsIt) {
  plug();
  process_.responses[kRun] = {3, 0, 0};
  host_->run(1);
  EXPECT_EQ(host_->write(1, {1}).status, kTransferStalled);
  EXPECT_EQ(host_->read(1)->status, kTransferStalled);
  process_.responses[kRun] = {0, 0, 0};
  EXPECT_EQ(host_->control_out(0x02, 1, 0, 0x01).status, 0);
  EXPECT_THAT(process_.last[kControl], ElementsAre(2, 1, 0, 0, 1, 0, 0, 0));
  EXPECT_EQ(host_->write(1, {1}).status, 0);
  process_.responses[kControl] = {1};
  EXPECT_EQ(host_->control_out(0x02, 1, 0, 0x81).status, kTransferStalled);
  EXPECT_THROW(board_.halt(0x81, 1), std::runtime_error) << "the firmware rejects it";
  EXPECT_THROW(board_.halt(0x81, 2), std::runtime_error);
}

TEST_F(ForwardedBoard, WritesItsEventsToTheTrace) {
  plug();
  process_.responses[kRun] = {0, 0, 0, '{', '}', '\n'};
  host_->run(2);
  EXPECT_EQ(folder_.read("trace"), "{}\n{}\n");
}

TEST_F(ForwardedBoard, HasTheStatusOfItsProcessAndTheTimeOfAnExchange) {
  const std::string text = R"({"board_us":5})";
  process_.responses[kStatus] = Bytes(text.begin(), text.end());
  EXPECT_THAT(board_.status(), StartsWith(R"({"board_us":5,"exchange_us":0.0,)"));
  process_.responses[kStatus] = {};
  EXPECT_THROW(board_.status(), std::runtime_error);
}

TEST_F(ForwardedBoard, EndsWithASentenceWhenItsProcessFails) {
  plug();
  const auto expect_failure = [&](const std::string& text) {
    try {
      board_.step();
      ADD_FAILURE() << "no exception: " << text;
    } catch (const std::runtime_error& e) {
      EXPECT_THAT(e.what(), HasSubstr(text));
    }
    process_.pending.clear();
  };
  process_.responses[kRun] = {0, 0, 1, 64};
  expect_failure("too short");
  process_.error = "the converter is selected again too soon";
  expect_failure("reports: the converter is selected");
  process_.error.clear();
  process_.crc_error = 1;
  expect_failure("a wrong check sum");
  process_.silent = true;
  expect_failure("does not respond");
}

}  // namespace
}  // namespace hedgehog::emulator
