// SPDX-License-Identifier: MIT
// device.list: which device is used, why the others are not, and that the io thread does not wait
// for it.
#include "daemon/device_list.h"

#include <gtest/gtest.h>

#include "daemon/device/usb/board_choice.h"
#include "tests/server/server_rig.h"

namespace hedgehog::daemon {
namespace {

device::UsbDevice usb(const std::string& port, int address, std::uint16_t vendor,
                      std::uint16_t product, const std::string& name,
                      const std::string& serial = "") {
  return {{1, address, -1}, vendor, product, "", name, serial, port, "0102", {{0, 0xFF, 0x48, 1}}};
}

device::HidDevice temper(int address) {
  device::HidDevice hid;
  hid.vendor = 0x413D;
  hid.product = 0x2107;
  hid.name = "PCsensor TEMPer2";
  hid.usb = device::UsbPlace{1, address, 1};
  return hid;
}

DeviceFacts facts() {
  DeviceFacts facts;
  facts.board_ids.ids = {{0x1209, 0x0001}};
  facts.board = device::BoardUsbInfo{};
  return facts;
}

device::UsbDevice board(int address = 4) {
  return usb("1-3", address, 0x1209, 0x0001, "Hedgehog driver board", "7");
}

TEST(DeviceList, TheOpenBoardIsInUse) {
  DeviceFacts known = facts();
  known.board->open = true;
  known.board->place = device::UsbPlace{1, 4, -1};
  const auto seen = seen_devices({board(), board(5)}, {}, known);
  ASSERT_EQ(seen.devices.size(), 2u);
  EXPECT_EQ(seen.devices[0].path, "USB 1-3");
  EXPECT_EQ(seen.devices[0].ids, "1209:0001");
  EXPECT_EQ(seen.devices[0].serial, "7");
  EXPECT_EQ(seen.devices[0].firmware, "1.02");
  EXPECT_EQ(seen.devices[0].protocol, "1") << "by its interface; its telemetry has the rest";
  EXPECT_EQ(seen.devices[0].use, "board");
  EXPECT_FALSE(seen.devices[0].why_not);
  EXPECT_FALSE(seen.devices[1].use);
  EXPECT_EQ(seen.devices[1].why_not, "another board is used");
}

TEST(DeviceList, TheReasonABoardIsNotUsedDoesNotRepeatItsName) {
  DeviceFacts known = facts();
  known.board->what = device::describe_board(board()) + ": another program has it";
  EXPECT_EQ(seen_devices({board()}, {}, known).devices[0].why_not, "another program has it");
  known.board.reset();
  EXPECT_EQ(seen_devices({board()}, {}, known).devices[0].why_not,
            "the ball is simulated (backend in the configuration)");
}

TEST(DeviceList, SensorsAreMatchedWithTheConfiguration) {
  const auto mti = usb("1-4", 6, 0x2639, 0x0003, "MTi-30", "0368248C");
  const auto stick = usb("1-6", 7, 0x413D, 0x2107, "TEMPer2");
  const auto awinda = usb("1-5", 8, 0x2639, 0x0101, "Awinda Station");
  DeviceFacts known = facts();
  auto seen = seen_devices({mti, awinda, stick}, {temper(7)}, known);
  ASSERT_EQ(seen.devices.size(), 3u);
  EXPECT_EQ(seen.devices[0].why_not, "imu.type in the configuration is \"none\", not \"mti\"");
  EXPECT_EQ(seen.devices[1].why_not, "only the manufacturer's closed software supports it");
  EXPECT_EQ(seen.devices[2].why_not, "thermometer.type in the configuration is not \"temper\"");

  known.lines = {{"imu", "mti", {true, "MTi-30 (2639:0003)", 1}},
                 {"thermometer",
                  "temper",
                  {false, "PCsensor TEMPer2 (413d:2107): /dev/hidraw2: Permission denied", 0}}};
  seen = seen_devices({mti, stick}, {temper(7)}, known);
  EXPECT_EQ(seen.devices[0].use, "imu");
  EXPECT_EQ(seen.devices[1].why_not, "/dev/hidraw2: Permission denied");
  EXPECT_TRUE(seen.missing.empty());
}

TEST(DeviceList, ListsMissingDevicesAndIgnoresOthers) {
  DeviceFacts known = facts();
  known.lines = {{"board", "usb", {false, "no driver board is connected (1209:0001)", 0}}};
  auto hub = usb("usb1", 1, 0x1D6B, 0x0002, "xHCI Host Controller");
  const auto seen = seen_devices({hub, usb("1-1", 2, 0x046D, 0xC31C, "Keyboard")}, {}, known);
  EXPECT_TRUE(seen.devices.empty());
  EXPECT_EQ(seen.others, 1);
  ASSERT_EQ(seen.missing.size(), 1u);
  EXPECT_EQ(seen.missing[0].use, "board");
  EXPECT_EQ(seen.missing[0].why, "no driver board is connected (1209:0001)");
}

struct SlowScanner : server::DeviceScanner {
  Ready scan() override {
    return [this]() -> std::optional<protocol::DevicesResult> {
      if (--pumps > 0) return std::nullopt;
      protocol::DevicesResult found;
      found.others = 7;
      found.devices = {{"USB 1-3", "1209:0001", "Board", {}, "1.02", "1", "board", {}},
                       {"USB 1-4", "1209:0001", "Board", {}, "1.01", "1", {}, "another is used"}};
      return found;
    };
  }
  int pumps = 20;
};

TEST(DeviceList, TheResponseIsSentWhenTheScanEndsAndDelaysNoOther) {
  server::ServerRig rig;
  SlowScanner scanner;
  rig.server->set_devices(scanner);
  auto& client = rig.connect(protocol::Role::kObserve);
  auto& other = rig.connect();
  rig.server->line(client.session, R"({"jsonrpc":"2.0","id":1,"method":"device.list"})");
  EXPECT_TRUE(rig.call(other, "ping").contains("time_ns"));
  EXPECT_TRUE(client.lines.empty());
  rig.run(30);
  ASSERT_FALSE(client.lines.empty());
  const auto found = server::Json::parse(client.lines.front().text)["result"];
  EXPECT_EQ(found["others"], 7);
  EXPECT_EQ(found["devices"][0]["protocol"], "1.2") << "as its telemetry says";
  EXPECT_EQ(found["devices"][1]["protocol"], "1") << "nobody has heard that one";
}

}  // namespace
}  // namespace hedgehog::daemon
