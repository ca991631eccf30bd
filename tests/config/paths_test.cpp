// SPDX-License-Identifier: MIT
#include "daemon/config/paths.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "tests/temporary_folder.h"

namespace hedgehog::config {
namespace {

Environment variables(std::map<std::string, std::string> set) {
  return [set = std::move(set)](const char* name) -> std::optional<std::string> {
    const auto found = set.find(name);
    if (found == set.end()) return std::nullopt;
    return found->second;
  };
}

TEST(Paths, UnderSystemd) {
  const Paths paths = find_paths(variables({{"RUNTIME_DIRECTORY", "/run/hedgehog"},
                                            {"STATE_DIRECTORY", "/var/lib/hedgehog:/var/lib/b"},
                                            {"HOME", "/nonexistent"}}),
                                 std::nullopt);
  EXPECT_EQ(paths.config_file, "/etc/hedgehog/hedgehogd.json");
  EXPECT_EQ(paths.runtime_directory, "/run/hedgehog");
  EXPECT_EQ(paths.state_directory, "/var/lib/hedgehog");
  EXPECT_FALSE(paths.config_file_required);
}

TEST(Paths, WithoutSystemdAsXdgSpecifies) {
  const Paths paths = find_paths(variables({{"HOME", "/people/ada"},
                                            {"XDG_RUNTIME_DIR", "/run/user/1000"},
                                            {"XDG_CONFIG_HOME", "relative/is/ignored"}}),
                                 std::nullopt);
  EXPECT_EQ(paths.config_file, "/people/ada/.config/hedgehog/hedgehogd.json");
  EXPECT_EQ(paths.state_directory, "/people/ada/.local/state/hedgehog");
  EXPECT_EQ(paths.runtime_directory, "/run/user/1000/hedgehog");

  const Paths moved =
      find_paths(variables({{"XDG_STATE_HOME", "/s"}, {"XDG_CONFIG_HOME", "/c"}, {"HOME", "/h"}}),
                 std::nullopt);
  EXPECT_EQ(moved.config_file, "/c/hedgehog/hedgehogd.json");
  EXPECT_EQ(moved.state_directory, "/s/hedgehog");
  EXPECT_EQ(moved.runtime_directory, "/tmp/hedgehog-" + std::to_string(getuid()));
}

TEST(Paths, TheOptionReplacesTheFileAndMustExist) {
  const Paths paths = find_paths(variables({{"HOME", "/h"}}), "mine.json");
  EXPECT_EQ(paths.config_file, "mine.json");
  EXPECT_TRUE(paths.config_file_required);
  EXPECT_EQ(paths.state_directory, "/h/.local/state/hedgehog");
}

TEST(Paths, InstalledFilesAreThoseOfTheOwnPrefix) {
  const TemporaryFolder prefix;
  const std::string share = prefix.path() + "/share/hedgehog";
  const auto none = variables({{"HOME", "/h"}});
  const Paths built = find_paths(none, std::nullopt, prefix.path() + "/bin/hedgehogd");
  EXPECT_EQ(built.defaults_file, "/usr/share/hedgehog/hedgehogd.json");
  EXPECT_EQ(built.device_directories, std::vector<std::string>{"/usr/share/hedgehog/devices.d"});
  std::filesystem::create_directories(share + "/devices.d");
  std::ofstream(share + "/hedgehogd.json") << "{}";
  const Paths installed = find_paths(none, std::nullopt, prefix.path() + "/bin/hedgehogd");
  EXPECT_EQ(installed.defaults_file, share + "/hedgehogd.json");
  EXPECT_EQ(installed.pages_directory, share + "/www");
  EXPECT_EQ(installed.device_directories,
            (std::vector<std::string>{share + "/devices.d", "/usr/share/hedgehog/devices.d"}));
  EXPECT_EQ(find_paths(none, std::nullopt, "/usr/bin/hedgehogd").device_directories.size(), 1u);
}

}  // namespace
}  // namespace hedgehog::config
