// SPDX-License-Identifier: MIT
// Devices that the daemon finds in /sys, in a simulated tree.
#include "daemon/device/sensors/drivers.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/device/hid_examples.h"
#include "tests/temporary_folder.h"

namespace hedgehog::device {
namespace {

namespace fs = std::filesystem;

class FakeSys : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root_ / "bus/usb/devices");
    fs::create_directories(root_ / "bus/hid/devices");
  }

  static void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }

  /// A USB device as in the kernel's sysfs: attributes with a newline at their end.
  fs::path usb(const std::string& port, const std::string& vendor, const std::string& product,
               int address, const std::string& name = "", const std::string& serial = "") {
    fs::path device = root_ / "devices" / port;
    put(device / "idVendor", vendor + "\n");
    put(device / "idProduct", product + "\n");
    put(device / "busnum", "1\n");
    put(device / "devnum", std::to_string(address) + "\n");
    if (!name.empty()) put(device / "product", name + "\n");
    if (!serial.empty()) put(device / "serial", serial + "\n");
    fs::create_directory_symlink(device, root_ / "bus/usb/devices" / port);
    return device;
  }

  void hid(const fs::path& parent, const std::string& id, const std::vector<Byte>& descriptor,
           const std::string& name, const std::string& serial, const std::string& node,
           int interface = -1) {
    const fs::path device = parent / id;
    put(device / "report_descriptor", {descriptor.begin(), descriptor.end()});
    put(device / "uevent", "DRIVER=x\nHID_ID=" + id + "\nHID_NAME=" + name +
                               "\nHID_UNIQ=" + serial + "\nMODALIAS=hid:b\n");
    if (!node.empty()) put(device / "hidraw" / node / "dev", "1:1");
    if (interface >= 0) put(parent / "bInterfaceNumber", "0" + std::to_string(interface) + "\n");
    fs::create_directory_symlink(device, root_ / "bus/hid/devices" / id);
  }

  std::string sys() const { return root_.string(); }
  TemporaryFolder folder_;
  fs::path root_ = folder_.path();
};

TEST_F(FakeSys, AnEmptyMachineHasNothing) {
  EXPECT_TRUE(list_usb(sys()).empty());
  EXPECT_TRUE(list_hid(sys()).empty());
  EXPECT_TRUE(list_hid("/nowhere").empty());
  EXPECT_EQ(find_sensor(list_hid(sys()), kDualSenseDriver, "").failure,
            "no DualSense pad is connected");
}

TEST_F(FakeSys, APadOnUsbAndOneOnBluetooth) {
  const fs::path wired = usb("1-2", "054c", "0ce6", 7, "DualSense");
  hid(wired / "1-2:1.3", "0003:054C:0CE6.0001", {0x05, 0x01}, "Sony DualSense", "aa:bb", "hidraw0",
      3);
  hid(root_ / "devices/bt", "0005:054C:09CC.0002", {0x05, 0x01}, "Wireless Controller", "cc:dd",
      "hidraw4");
  const auto devices = list_hid(sys());
  ASSERT_EQ(devices.size(), 2u);
  EXPECT_EQ(driver_of(devices[0]), &kDualSenseDriver);
  EXPECT_EQ(devices[0].hidraw, "/dev/hidraw0");
  EXPECT_EQ(devices[0].usb, (UsbPlace{1, 7, 3}));
  EXPECT_FALSE(devices[0].bluetooth);
  EXPECT_EQ(describe(devices[0]), "Sony DualSense (054c:0ce6)");
  EXPECT_EQ(driver_of(devices[1]), &kDualShock4Driver);
  EXPECT_TRUE(devices[1].bluetooth);
  EXPECT_FALSE(devices[1].usb);
  EXPECT_EQ(devices[1].serial, "cc:dd");
}

// hid-sensor-hub of Linux 6.1 creates no hidraw node; the sensor is identified by its place on the
// bus.
TEST_F(FakeSys, AnOrientationSensorWithoutANode) {
  const fs::path device = usb("1-1", "1bae", "01ca", 3);
  hid(device / "1-1:1.0", "0003:1BAE:01CA.0001", short_orientation_descriptor(), "Glasses", "", "",
      0);
  const auto devices = list_hid(sys());
  ASSERT_EQ(devices.size(), 1u);
  EXPECT_EQ(driver_of(devices[0]), &kHidSensorDriver);
  EXPECT_EQ(devices[0].hidraw, "");
  EXPECT_EQ(devices[0].usb, (UsbPlace{1, 3, 0}));
  EXPECT_EQ(find_sensor(devices, kHidSensorDriver, "").index, 0u);
}

TEST_F(FakeSys, OfATemperTheSecondInterface) {
  const fs::path stick = usb("1-4", "413d", "2107", 9);
  hid(stick / "1-4:1.0", "0003:413D:2107.0001", mouse_descriptor(), "TEMPer2", "", "hidraw1", 0);
  hid(stick / "1-4:1.1", "0003:413D:2107.0002", {0x06, 0, 0xFF}, "TEMPer2", "", "hidraw2", 1);
  const auto devices = list_hid(sys());
  const Found found = find_sensor(devices, kTemperDriver, "");
  ASSERT_TRUE(found.index) << found.failure;
  EXPECT_EQ(devices[*found.index].hidraw, "/dev/hidraw2");
}

TEST_F(FakeSys, TwoOfAKindNeedASerialNumber) {
  hid(root_ / "devices/a", "0005:054C:0CE6.0001", {}, "One", "aa", "hidraw0");
  hid(root_ / "devices/b", "0005:054C:0CE6.0002", {}, "Two", "bb", "hidraw1");
  const auto devices = list_hid(sys());
  EXPECT_EQ(find_sensor(devices, kDualSenseDriver, "").failure,
            "two of them are connected, One (054c:0ce6) and Two (054c:0ce6); the setting `serial` "
            "says which");
  EXPECT_EQ(find_sensor(devices, kDualSenseDriver, "bb").index, 1u);
  EXPECT_EQ(find_sensor(devices, kDualSenseDriver, "cc").failure,
            "no DualSense pad with serial number cc, only with others");
}

TEST_F(FakeSys, AnMtiAndARadioStation) {
  usb("1-1", "2639", "0003", 2, "MTi-30", "0368248C");
  usb("1-2", "2639", "0101", 3, "Awinda Station");
  put(root_ / "bus/usb/devices/1-1:1.0/bInterfaceNumber", "00\n");
  const auto devices = list_usb(sys());
  ASSERT_EQ(devices.size(), 2u);
  EXPECT_EQ(driver_of(devices[0]), &kMtiDriver);
  EXPECT_EQ(devices[0].serial, "0368248C");
  EXPECT_EQ(describe(devices[0]), "MTi-30 (2639:0003)");
  EXPECT_EQ(driver_of(devices[1]), &kClosedXsensDriver);
  EXPECT_EQ(find_sensor(devices, kMtiDriver, "").index, 0u);
}

// Of a device unplugged between open and read, files can be opened but not read. A folder in place
// of the file behaves the same.
TEST_F(FakeSys, AnAttributeThatCannotBeReadIsLeftOut) {
  const fs::path pulled = usb("1-1", "2639", "0003", 2, "MTi-30");
  fs::create_directory(pulled / "serial");
  const fs::path removed = usb("1-2", "2639", "0003", 3, "MTi-30");
  fs::remove(removed / "idVendor");
  fs::create_directory(removed / "idVendor");
  hid(root_ / "devices/bt", "0005:054C:09CC.0002", {0x05, 0x01}, "Pad", "cc:dd", "hidraw4");
  for (const char* file : {"report_descriptor", "uevent"}) {
    fs::remove(root_ / "devices/bt/0005:054C:09CC.0002" / file);
    fs::create_directory(root_ / "devices/bt/0005:054C:09CC.0002" / file);
  }
  const auto usb_devices = list_usb(sys());
  ASSERT_EQ(usb_devices.size(), 1u);
  EXPECT_EQ(usb_devices[0].serial, "");
  EXPECT_EQ(usb_devices[0].name, "MTi-30");
  const auto hid_devices = list_hid(sys());
  ASSERT_EQ(hid_devices.size(), 1u);
  EXPECT_EQ(hid_devices[0].name, "");
  EXPECT_TRUE(hid_devices[0].descriptor.empty());
}

}  // namespace
}  // namespace hedgehog::device
