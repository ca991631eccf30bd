// SPDX-License-Identifier: MIT
// Which listener is announced on the network, and with which records. tests/discovery runs a real
// Avahi.
#include "daemon/announcement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::daemon {
namespace {

using testing::ElementsAre;

TEST(Announcement, IsOfTheFirstListenerThatIsReachableRemotely) {
  EXPECT_EQ(announced_port({}), std::nullopt);
  EXPECT_EQ(announced_port({"127.0.0.1:7586", "[::1]:7586", "127.1.2.3:7", "localhost:7586",
                            "http://127.0.0.1:7587", "/run/hedgehog/hedgehogd.sock"}),
            std::nullopt);
  EXPECT_EQ(announced_port({"127.0.0.1:7586", "tls://127.0.0.1:7", "tls://192.0.2.7:17586",
                            "tls://10.0.0.1:9"}),
            17586);
  EXPECT_EQ(announced_port({"tls://[2001:db8::7]:7588"}), 7588);
  EXPECT_EQ(announced_port({"tls://0.0.0.0:7586"}), 7586);
  EXPECT_EQ(announced_port({"tls://[::]:7586"}), 7586);
}

TEST(Announcement, IsNotOfWebPagesAndSockets) {
  EXPECT_EQ(announced_port({"https://192.0.2.7:7587", "/a:12/socket", "", "tls://",
                            "tls://:", "tls://192.0.2.7:0"}),
            std::nullopt);
}

TEST(Announcement, HasProtocolSerialAndTls) {
  EXPECT_THAT(txt_records({"ball-7", 7586, "0007", "1.0"}),
              ElementsAre("protocol=1.0", "serial=0007", "tls=1"));
  EXPECT_THAT(txt_records({"ball-7", 7586, "", "1.0"}), ElementsAre("protocol=1.0", "tls=1"));
}

}  // namespace
}  // namespace hedgehog::daemon
