// SPDX-License-Identifier: MIT
// `hedgehogctl play` distinguishes files and names of patterns.
#include "clients/ctl/patterns/pattern_file.h"
#include "clients/ctl/play_options.h"
#include "tests/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace hedgehog::client {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kAhap = R"({"Version":1,"Pattern":[{"Event":{"Time":0,
    "EventType":"HapticTransient","EventParameters":[
    {"ParameterID":"HapticIntensity","ParameterValue":0.9},
    {"ParameterID":"HapticSharpness","ParameterValue":0.4}]}}]})";
constexpr const char* kHjif = R"({"version":"2023","timescale":1000,"perceptions":[
    {"perception_modality":"Vibrotactile","channels":[{"gain":1.0,"bands":[
    {"band_type":"Curve","curve_type":"Linear","effects":[{"effect_type":"Basis","position":0,"keyframes":[
    {"relative_position":0,"amplitude_modulation":1.0},
    {"relative_position":40,"amplitude_modulation":0.0}]}]}]}]}]})";

/// An empty working directory during this object's lifetime.
class EmptyFolder {
 public:
  EmptyFolder() { std::filesystem::current_path(folder_.path()); }
  ~EmptyFolder() { std::filesystem::current_path(before_); }
  EmptyFolder(const EmptyFolder&) = delete;
  EmptyFolder& operator=(const EmptyFolder&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  TemporaryFolder folder_;
};

TEST(PatternFile, ANameThatEndsInJsonIsAFileUnlessItIsAVendorsAndTheFileIsMissing) {
  const EmptyFolder here;
  EXPECT_FALSE(is_pattern_file("heartbeat"));
  EXPECT_FALSE(is_pattern_file("acme/knock"));
  EXPECT_TRUE(is_pattern_file("mine.json")) << "no shipped pattern ends so";
  EXPECT_TRUE(is_pattern_file("/nowhere/mine.json"));
  EXPECT_TRUE(is_pattern_file("Patterns/mine.json")) << "capitals are no pattern's name";
  EXPECT_FALSE(is_pattern_file("acme/x.json")) << "a legal name, and no file";
  EXPECT_TRUE(is_pattern_file("./acme/x.json"));
  std::filesystem::create_directory("acme");
  EXPECT_FALSE(is_pattern_file("acme/x.json"));
  std::ofstream("acme/x.json") << "{}";
  EXPECT_TRUE(is_pattern_file("acme/x.json")) << "the file is nearer";
}

TEST(PatternFile, OtherFormatsAreRecognisedByTheirExtensionInCapitalsToo) {
  const EmptyFolder here;
  for (const char* file : {"boing.ahap", "Boing.AHAP", "buzz.hjif", "/nowhere/Buzz.Hjif"})
    EXPECT_TRUE(is_pattern_file(file)) << file;
  for (const char* name : {"acme/boing.ahap", "ahap", "boing.ahap.txt", "boing.midi"})
    EXPECT_FALSE(is_pattern_file(name)) << name;
}

TEST(PatternFile, IsReadAccordingToItsExtension) {
  const TemporaryFolder folder;
  const auto own = read_any_pattern(
      folder.write("own.json", R"({"name":"a/b","keyframes":[{"t_ms":5,"level":1}]})"));
  ASSERT_TRUE(own) << own.error().message;
  EXPECT_EQ(own->pattern.keyframes.size(), 1u);
  EXPECT_TRUE(own->notes.empty());

  const auto ahap = read_any_pattern(folder.write("My Boing.AHAP", kAhap));
  ASSERT_TRUE(ahap) << ahap.error().message;
  EXPECT_EQ(ahap->pattern.name, "imported/my-boing");
  EXPECT_EQ(ahap->pattern.keyframes.back().t_ms, 25);
  EXPECT_THAT(ahap->notes, ElementsAre(HasSubstr("HapticSharpness is left out")));

  const auto hjif = read_any_pattern(folder.write("buzz.hjif", kHjif));
  ASSERT_TRUE(hjif) << hjif.error().message;
  EXPECT_EQ(hjif->pattern.keyframes.back().level, 0.0);
}

TEST(PatternFile, AnErrorNamesTheFileThePositionAndTheAllowedValues) {
  const TemporaryFolder folder;
  const auto error_of = [&](const char* name, const std::string& text) {
    const std::string path = folder.write(name, text);
    const auto read = read_any_pattern(path);
    EXPECT_FALSE(read);
    EXPECT_EQ(read.error().failure, Failure::kBadData);
    EXPECT_THAT(read.error().message, StartsWith(path + ": "));
    return read.error().message;
  };
  EXPECT_THAT(error_of("broken.ahap", R"({"Pattern":[})"), HasSubstr("invalid at byte 13"));
  EXPECT_THAT(error_of("other.hjif", "{}"), HasSubstr("neither AHAP"));
  EXPECT_THAT(error_of("list.ahap", R"({"Pattern":{}})"), HasSubstr("has a list of that name"));
  EXPECT_THAT(error_of("audio.ahap", R"({"Pattern":[{"Event":{"EventType":"AudioCustom"}}]})"),
              HasSubstr("there is no haptic event in the file that a ball can play"));
  EXPECT_THAT(error_of("own.json", R"({"name":"a/b","keyframes":[{"t_ms":5,"level":7}]})"),
              HasSubstr("keyframes[0].level"));
  EXPECT_EQ(read_any_pattern(folder.path("none.ahap")).error().failure, Failure::kNoInput);
}

PlayOptions played(const std::string& file,
                   std::vector<std::pair<std::string, std::string>> params = {}) {
  return {.method = "effect.play", .pattern = file, .params = std::move(params)};
}

TEST(PlayedFile, BecomesTheKeyFramesOfTheEffect) {
  const TemporaryFolder folder;
  const auto read = with_file(played(folder.write("boing.ahap", kAhap), {{"level", "0.5"}}));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_FALSE(read->options.held());
  const std::string params = play_params(read->options).value();
  EXPECT_THAT(params, HasSubstr(R"("keyframes":[)"));
  EXPECT_THAT(params, HasSubstr(R"("level":0.5)"));
  EXPECT_THAT(params, Not(HasSubstr("boing"))) << "neither file nor name";
}

TEST(PlayedFile, LongerThanAnEffectMayLastIsRenewedUntilItsEnd) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "long.json", R"({"name":"a/b","keyframes":[{"t_ms":0,"level":1},{"t_ms":30000,"level":0}]})");
  EXPECT_EQ(with_file(played(file))->options.hold_s, 30.0);
  EXPECT_EQ(with_file(played(file, {{"rate", "2"}}))->options.hold_s, 15.0);
  EXPECT_EQ(with_file(played(file, {{"rate", "3"}}))->options.hold_s, std::nullopt);
  EXPECT_EQ(with_file(played(file, {{"rate", "fast"}}))->options.hold_s, std::nullopt);
  EXPECT_EQ(with_file(played(file, {{"duration_ms", "50"}}))->options.hold_s, std::nullopt);
  EXPECT_EQ(with_file(played(file, {{"lease_ms", "500"}}))->options.hold_s, std::nullopt)
      << "until Ctrl-C";
}

TEST(PlayedFile, OfAnotherFormatIsRefusedWithTheSupportedOnes) {
  const TemporaryFolder folder;
  const std::string file = folder.write("Drum.midi", "MThd");
  const auto read = with_file(played(file));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().failure, Failure::kBadData);
  EXPECT_THAT(read.error().message, StartsWith(file + ": plays files ending in .json, .ahap"));
  EXPECT_TRUE(with_file(played("heartbeat"))) << "a name";
}

TEST(PatternFile, IsRefusedWithoutBlockingIfItIsNoRegularFile) {
  const TemporaryFolder folder;
  const std::string fifo = folder.path("fifo.json");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_EQ(read_text(fifo).error().message, fifo + ": is a FIFO, not a regular file");
  EXPECT_EQ(read_text("/dev/full").error().message, "/dev/full: is a device, not a regular file");
  EXPECT_EQ(read_text(folder.path()).error().message,
            folder.path() + ": is a folder, not a regular file");
  EXPECT_EQ(read_text(folder.path("none")).error().failure, Failure::kNoInput);
  EXPECT_EQ(read_text(folder.write("some.json", "{}")).value(), "{}");
}

}  // namespace
}  // namespace hedgehog::client
