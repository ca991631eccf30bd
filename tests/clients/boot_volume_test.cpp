// SPDX-License-Identifier: MIT
// Detection of the boot loader's volume among the mounted ones, and writing of an image to it.
#include "clients/ctl/board/boot_volume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "clients/ctl/board/image_load.h"
#include "tests/temporary_folder.h"

namespace hedgehog::client {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kInfo =
    "UF2 Bootloader v3.0\r\nModel: Raspberry Pi RP2\r\nBoard-ID: RPI-RP2\r\n";

struct BootVolume : testing::Test {
  TemporaryFolder folder;

  std::string volume(const std::string& name, const std::string& info = kInfo) const {
    std::filesystem::create_directories(folder.path(name));
    folder.write(name + "/INFO_UF2.TXT", info);
    return folder.path(name);
  }
  ImageLoad load(std::vector<std::string> volumes) const {
    ImageLoad load;
    load.file = folder.path("image.uf2");
    load.content = "image";
    load.volumes = [volumes] { return volumes; };
    return load;
  }
};

TEST_F(BootVolume, IsIdentifiedByItsInfoFile) {
  EXPECT_TRUE(is_boot_volume(volume("pico")));
  EXPECT_FALSE(
      is_boot_volume(volume("pico2", "Model: Raspberry Pi RP2350\r\nBoard-ID: RP2350\r\n")));
  EXPECT_FALSE(is_boot_volume(volume("odd", "Board-ID: RPI-RP2040\n")));
  EXPECT_FALSE(is_boot_volume(folder.path("nothing")));
  EXPECT_FALSE(is_boot_volume(volume("large", std::string(5000, '\n') + kInfo)));
}

TEST_F(BootVolume, IsFoundAmongFatFileSystems) {
  const std::string pico = volume("RPI RP2");
  std::string escaped = pico;
  escaped.replace(escaped.find(' '), 1, "\\040");
  volume("other", "Board-ID: RP2350\n");
  const std::string mounts =
      "proc /proc proc rw 0 0\n"
      "/dev/sda1 " +
      folder.path("other") +
      " vfat rw 0 0\n"
      "/dev/sdb1 " +
      escaped +
      " vfat rw,nosuid 0 0\n"
      "nonsense\n";
  EXPECT_THAT(boot_volumes(mounts), ElementsAre(pico));
  EXPECT_THAT(boot_volumes("server:/x " + escaped + " nfs4 rw 0 0\n"), IsEmpty())
      << "a network's file system may hang";
  EXPECT_THAT(boot_volumes("/dev/sdb1 " + escaped + " msdos rw 0 0\n"), ElementsAre(pico));
  EXPECT_THAT(boot_volumes(""), IsEmpty());
}

TEST_F(BootVolume, ReceivesACopy) {
  const std::string pico = volume("pico");
  const std::string content(100'000, 'x');
  EXPECT_EQ(copy_to_volume(pico, content), "");
  EXPECT_EQ(folder.read("pico/hedgehog.uf2"), content);
  EXPECT_EQ(copy_to_volume(pico, "shorter"), "");
  EXPECT_EQ(folder.read("pico/hedgehog.uf2"), "shorter");
}

TEST_F(BootVolume, ReportsWhyNothingWasCopied) {
  EXPECT_EQ(copy_to_volume(folder.path("gone"), "x"),
            folder.path("gone") + "/hedgehog.uf2 cannot be written: No such file or directory");
  const std::string pico = volume("pico");
  // A disk that is full.
  std::filesystem::create_symlink("/dev/full", pico + "/hedgehog.uf2");
  EXPECT_THAT(copy_to_volume(pico, "x"), HasSubstr("cannot be written: No space left on device"));
}

TEST_F(BootVolume, IsWrittenOnlyIfItIsTheOnlyOne) {
  const std::string first = volume("first");
  const std::string second = volume("second");
  const auto two = load_image(load({first, second}));
  ASSERT_FALSE(two);
  EXPECT_EQ(two.error().exit_code, kUnavailable);
  EXPECT_EQ(two.error().message, "two boards are in their boot loaders, " + first + " and " +
                                     second + ": select the ball's with --volume");
  const auto one = load_image(load({first}));
  ASSERT_TRUE(one);
  EXPECT_EQ(one->volume, first);
  EXPECT_EQ(folder.read("first/hedgehog.uf2"), "image");
}

TEST_F(BootVolume, OnlyTheNamedOneIsUsed) {
  ImageLoad named = load({volume("first")});
  named.volume = folder.path("second");
  const auto missing = load_image(named);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().exit_code, kUnavailable);
  EXPECT_EQ(missing.error().message,
            named.volume + " is not the volume RPI-RP2 of a board in its boot loader");
  volume("second");
  const auto loaded = load_image(named);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->volume, named.volume);
  EXPECT_FALSE(std::filesystem::exists(folder.path("first/hedgehog.uf2")));
}

TEST_F(BootVolume, IsWaitedFor) {
  int polls = 0;
  ImageLoad later = load({});
  later.timeout = std::chrono::minutes(1);
  later.volumes = [&] {
    return ++polls < 3 ? std::vector<std::string>() : std::vector{volume("pico")};
  };
  EXPECT_TRUE(load_image(later));
  EXPECT_EQ(polls, 3);
}

TEST_F(BootVolume, AFailedCopyIsReported) {
  const std::string pico = volume("pico");
  std::filesystem::create_symlink("/dev/full", pico + "/hedgehog.uf2");
  const auto full = load_image(load({pico}));
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().exit_code, kCannotCreate);
}

}  // namespace
}  // namespace hedgehog::client
