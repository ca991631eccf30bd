// SPDX-License-Identifier: MIT
// systemd/60-hedgehog.rules lists exactly the devices supported by the code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "daemon/device/sensors/drivers.h"
#include "tests/folders.h"

namespace hedgehog::device {
namespace {

using Ids = std::set<std::pair<int, int>>;

std::string installed(const std::string& file) {
  std::ifstream in(source_folder() + "/systemd/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string rules() { return installed("60-hedgehog.rules"); }

int hex(const std::string& text) { return std::stoi(text, nullptr, 16); }

/// Ids in lines with ATTR{idVendor} and ATTR{idProduct}.
Ids usb_ids(const std::string& text) {
  Ids ids;
  const std::regex line(R"re(ATTR\{idVendor\}=="(\w+)", ATTR\{idProduct\}=="([\w|]+)")re");
  const std::regex one(R"(\w+)");
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it) {
    const std::string products = (*it)[2];
    for (std::sregex_iterator p(products.begin(), products.end(), one); p != end; ++p)
      ids.emplace(hex((*it)[1]), hex(p->str()));
  }
  return ids;
}

Ids hid_ids(const std::string& text) {
  Ids ids;
  const std::regex one(R"(\*:([0-9A-F]{4}):([0-9A-F]{4})\.\*)");
  for (std::sregex_iterator it(text.begin(), text.end(), one), end; it != end; ++it)
    ids.emplace(hex((*it)[1]), hex((*it)[2]));
  return ids;
}

template <class Device, class Matches>
Ids known(const std::set<int>& vendors, Matches matches) {
  Ids ids;
  for (const int vendor : vendors) {
    for (int product = 0; product <= 0xFFFF; ++product) {
      Device device;
      device.vendor = static_cast<std::uint16_t>(vendor);
      device.product = static_cast<std::uint16_t>(product);
      if (matches(driver_of(device))) ids.emplace(vendor, product);
    }
  }
  return ids;
}

TEST(UdevRules, ListEveryKnownHidDevice) {
  EXPECT_EQ(hid_ids(rules()), (known<HidDevice>(
                                  {0x054C, 0x0C45, 0x413D, 0x1A86},
                                  [](const SensorDriver* driver) { return driver != nullptr; })));
}

TEST(UdevRules, ListTheMtiAndTheBoard) {
  Ids expected =
      known<UsbDevice>({0x2639}, [](const SensorDriver* driver) { return driver == &kMtiDriver; });
  expected.emplace(0x1209, 0x0001);
  EXPECT_EQ(usb_ids(rules()), expected);
}

TEST(Metainfo, OffersThePackageForTheBoardOfTheRules) {
  Ids ids;
  const std::string text = installed("hedgehogd.metainfo.xml");
  const std::regex one(R"(<modalias>usb:v(\w{4})p(\w{4})d\*</modalias>)");
  for (std::sregex_iterator it(text.begin(), text.end(), one), end; it != end; ++it)
    ids.emplace(hex((*it)[1]), hex((*it)[2]));
  EXPECT_EQ(ids, (Ids{{0x1209, 0x0001}}));
  EXPECT_TRUE(usb_ids(rules()).contains(*ids.begin()));
}

TEST(UdevRules, GiveAccessToTheGroupOnly) {
  const std::string text = rules();
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("0666")));
  const std::regex given(R"re(MODE="0660")re");
  const std::regex group(R"re(GROUP="hedgehog")re");
  const auto count = [&text](const std::regex& what) {
    return std::distance(std::sregex_iterator(text.begin(), text.end(), what), {});
  };
  EXPECT_EQ(count(given), 6);
  EXPECT_EQ(count(group), 6);
}

}  // namespace
}  // namespace hedgehog::device
