// SPDX-License-Identifier: MIT
// Files of web pages: compressed ones are sent to clients that accept them, and browsers keep those
// that never change.
#include "base/web_files.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/temporary_folder.h"

namespace hedgehog::base {
namespace {

constexpr const char* kScript = "export {};";
/// `kScript`, compressed by gzip.
constexpr std::array<unsigned char, 30> kPacked{
    0x1f, 0x8b, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02, 0xff, 0x4b, 0xad, 0x28, 0xc8, 0x2f,
    0x2a, 0x51, 0xa8, 0xae, 0xb5, 0x06, 0x00, 0xc6, 0x47, 0x25, 0xd7, 0x0a, 0x00, 0x00, 0x00};

std::string packed() { return {kPacked.begin(), kPacked.end()}; }

class WebFilesTest : public testing::Test {
 protected:
  WebFiles read() const { return read_web_files(folder_.path(), WebFolder::kAlone, 1 << 20); }

  TemporaryFolder folder_;
};

TEST_F(WebFilesTest, ThePackedFileIsSentToClientsThatAcceptIt) {
  folder_.write("main.js", kScript);
  folder_.write("main.js.gz", packed());
  const WebFiles files = read();
  EXPECT_EQ(files.by_path.size(), 1u) << "a packed file is no page of its own";
  const WebFile& file = *files.find("/main.js");
  for (const char* accepted : {"gzip", "deflate, gzip;q=0.5", "br , gzip ; q=1"}) {
    const WebFileResponse response = web_file_response(file, accepted, "");
    EXPECT_EQ(*response.body, packed()) << accepted;
    EXPECT_EQ(response.encoding, "gzip");
    EXPECT_EQ(response.vary, "Accept-Encoding");
    EXPECT_NE(response.etag, file.etag) << "other bytes, another tag";
  }
  for (const char* accepted : {"", "br", "gzip;q=0", "gzip; q=0.000", "notgzip"}) {
    const WebFileResponse response = web_file_response(file, accepted, "");
    EXPECT_EQ(*response.body, kScript) << accepted;
    EXPECT_EQ(response.encoding, "");
    EXPECT_EQ(response.vary, "Accept-Encoding") << "for caches between";
  }
}

TEST_F(WebFilesTest, APackedFileOfOtherContentIsNotSent) {
  folder_.write("main.js", "export { changed };");
  folder_.write("main.js.gz", packed());
  folder_.write("short.js", "x");
  folder_.write("short.js.gz", "x");
  folder_.write("alone.js.gz", packed());
  const WebFiles files = read();
  for (const char* path : {"/main.js", "/short.js"}) {
    const WebFileResponse response = web_file_response(*files.find(path), "gzip", "");
    EXPECT_EQ(response.encoding, "") << path;
    EXPECT_EQ(response.vary, "");
  }
  EXPECT_EQ(files.find("/alone.js"), nullptr);
}

TEST_F(WebFilesTest, AnUnchangedFileIsNotSentAgain) {
  folder_.write("main.js", kScript);
  folder_.write("main.js.gz", packed());
  const WebFiles files = read();
  const WebFile& file = *files.find("/main.js");
  for (const char* accepted : {"", "gzip"}) {
    const std::string tag = web_file_response(file, accepted, "").etag;
    EXPECT_EQ(web_file_response(file, accepted, tag).body, nullptr);
    EXPECT_EQ(web_file_response(file, accepted, "\"other\", " + tag).body, nullptr);
    EXPECT_NE(web_file_response(file, accepted, "\"other\"").body, nullptr);
  }
  EXPECT_NE(web_file_response(file, "gzip", file.etag).body, nullptr) << "it has the other bytes";
  const WebFile without_tag{"text/plain", file.bytes};
  EXPECT_NE(web_file_response(without_tag, "", "\"any\"").body, nullptr);
}

TEST_F(WebFilesTest, OnlyANameWithAHashIsCachedForEver) {
  for (const char* name : {"chunk-3F2A9C0B.js", "main.js", "chunk-3f2a9c0b.js", "-AB.js"})
    folder_.write(name, kScript);
  const WebFiles files = read();
  const auto kept = [&](const char* path) {
    return web_file_response(*files.find(path), "", "").cache_control;
  };
  EXPECT_EQ(kept("/chunk-3F2A9C0B.js"), "public, max-age=31536000, immutable");
  for (const char* path : {"/main.js", "/chunk-3f2a9c0b.js", "/-AB.js"})
    EXPECT_EQ(kept(path), "no-cache") << path;
}

}  // namespace
}  // namespace hedgehog::base
