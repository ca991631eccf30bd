// SPDX-License-Identifier: MIT
// Access rights of device nodes: our sysusers file and udev rules, and the daemon as their user.
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "tests/folders.h"
#include "tests/vm/bench.h"

namespace hedgehog::vm {
namespace {

namespace fs = std::filesystem;

const std::string kHostileSerial = "x.service debug-shell.service y";

class Access : public Bench {
 protected:
  Access() : Bench(devices()) {}
  static std::vector<std::string> devices() {
    std::vector<std::string> all = kEveryDevice;
    all.push_back("board,unplugged,name=hostile,serial=" + kHostileSerial);
    return all;
  }

  static void SetUpTestSuite() {
    shell("systemd-sysusers " + source_folder() + "/systemd/hedgehog.sysusers");
    ASSERT_NE(::getgrnam("hedgehog"), nullptr);
    open_programs_to_all_users();
  }
  static void install_rules() {
    shell("mkdir -p /run/udev/rules.d && cp " + source_folder() +
          "/systemd/60-hedgehog.rules "
          "/run/udev/rules.d/ && udevadm control --reload");
  }
  static void TearDownTestSuite() {
    shell("rm -f /run/udev/rules.d/60-hedgehog.rules; udevadm control --reload");
  }

  static bool belongs_to_group(const fs::path& node) {
    struct stat state {};
    return ::stat(node.c_str(), &state) == 0 && state.st_gid == ::getgrnam("hedgehog")->gr_gid &&
           (state.st_mode & 0777) == 0660;
  }
  static std::string line(const fs::path& file) {
    std::string text = shell("cat " + file.string());
    return text.substr(0, text.find('\n'));
  }
  /// /dev/bus/usb/... of the device with this product string; empty: none.
  static std::string usb_node(const std::string& product) {
    for (const auto& entry : fs::directory_iterator("/sys/bus/usb/devices")) {
      if (!fs::exists(entry.path() / "product") || line(entry.path() / "product") != product)
        continue;
      char node[40];
      std::snprintf(node, sizeof node, "/dev/bus/usb/%03d/%03d",
                    std::stoi(line(entry.path() / "busnum")),
                    std::stoi(line(entry.path() / "devnum")));
      return node;
    }
    return {};
  }
  /// /dev/hidraw... of the HID devices with these ids.
  static std::vector<std::string> hidraw_nodes(const std::string& ids) {
    std::vector<std::string> nodes;
    for (const auto& entry : fs::directory_iterator("/sys/class/hidraw")) {
      std::error_code ignored;  // a driver may remove it meanwhile
      const std::string path = fs::canonical(entry.path(), ignored).string();
      if (path.find(ids) != std::string::npos)
        nodes.push_back("/dev/" + entry.path().filename().string());
    }
    return nodes;
  }
};

TEST_F(Access, WithoutTheRulesTheDaemonReportsWhatIsMissing) {
  configure();
  emulator_->ok("plug board");
  ASSERT_TRUE(eventually([] { return !usb_node("Hedgehog driver board").empty(); }));
  Daemon daemon(home_, "hedgehog");
  EXPECT_TRUE(daemon.logs("no permission")) << daemon.log();
  EXPECT_TRUE(daemon.logs("the udev rule gives it to the group hedgehog")) << daemon.log();
  EXPECT_EQ(daemon.state(), "absent");
}

TEST_F(Access, TheRulesAreValidForUdev) {
  install_rules();
  const std::string output = shell("udevadm test /sys/bus/usb/devices/usb1");
  EXPECT_NE(output.find("60-hedgehog.rules"), std::string::npos);
  for (const char* wrong :
       {"60-hedgehog.rules:1 ", "Invalid", "invalid", "nknown key", "gnoring"}) {
    const auto at = output.find(wrong);
    const bool own_rule =
        at != std::string::npos &&
        output.substr(output.rfind('\n', at) + 1, 200).find("60-hedgehog") != std::string::npos;
    EXPECT_FALSE(own_rule) << output.substr(at, 200);
  }
}

// systemd takes each word of SYSTEMD_WANTS for a unit, and would start it as root.
TEST_F(Access, ASerialNumberNamesNoOtherUnit) {
  install_rules();
  emulator_->ok("plug board");
  emulator_->ok("plug hostile");
  const auto wants = [](const std::string& serial) {
    return shell("udevadm info --query=property " +
                 shell("dirname $(grep -lx '" + serial + "' /sys/bus/usb/devices/*/serial)"));
  };
  EXPECT_TRUE(eventually([&] {
    return wants("B1").find("SYSTEMD_WANTS=hedgehogd@B1.service\n") != std::string::npos;
  })) << wants("B1");
  EXPECT_TRUE(eventually([&] {
    return wants(kHostileSerial).find("ID_MODEL=Hedgehog_driver_board\n") != std::string::npos;
  })) << wants(kHostileSerial);
  EXPECT_EQ(wants(kHostileSerial).find("SYSTEMD_WANTS"), std::string::npos);
}

TEST_F(Access, TheRulesGiveEveryDeviceToTheGroupAndTheDaemonPlaysAsItsUser) {
  install_rules();
  for (const char* device : {"board", "mti", "hid-sensor", "dualsense", "temper"})
    emulator_->ok(std::string("plug ") + device);
  for (const char* product : {"Hedgehog driver board", "MTi-30", "Orientation sensor"}) {
    EXPECT_TRUE(eventually([&] { return belongs_to_group(usb_node(product)); }))
        << product << shell("ls -l " + usb_node(product));
  }
  for (const char* ids : {":054C:0CE6.", ":413D:2107."}) {
    EXPECT_TRUE(eventually([&] {
      const auto nodes = hidraw_nodes(ids);
      return !nodes.empty() && std::all_of(nodes.begin(), nodes.end(), belongs_to_group);
    })) << ids
        << shell("ls -l /dev/hidraw*");
  }
  shell("udevadm settle");
  EXPECT_TRUE(belongs_to_group(usb_node("Orientation sensor"))) << "and stays so";
  const std::string board =
      shell("udevadm info --query=property --name=" + usb_node("Hedgehog driver board"));
  const auto serial = board.find("ID_SERIAL_SHORT=") + std::string("ID_SERIAL_SHORT=").size();
  EXPECT_NE(board.find("SYSTEMD_WANTS=hedgehogd@" +
                       board.substr(serial, board.find('\n', serial) - serial) + ".service\n"),
            std::string::npos)
      << board;

  for (const char* imu : {"mti", "hid_sensor", "dualsense"}) {
    configure({{"imu", {{"type", imu}}}});
    Daemon daemon(home_, "hedgehog");
    EXPECT_EQ(shell("stat -c %U /proc/" + std::to_string(daemon.pid()) + "/status"), "hedgehog\n");
    ASSERT_TRUE(eventually([&] { return daemon.state() != "absent"; })) << daemon.log();
    EXPECT_TRUE(eventually([&] {
      const Json orientation = daemon.status()["orientation"];
      return !orientation.is_null() && orientation.value("age_ms", 1000) < 100;
    })) << imu
        << daemon.log();
    if (std::string(imu) == "mti") {
      daemon.arm();
      EXPECT_GT(daemon.pulse(*emulator_, 5.0, 200), 4.8);
    }
    EXPECT_EQ(daemon.stop(), 0);
  }
}

}  // namespace
}  // namespace hedgehog::vm
