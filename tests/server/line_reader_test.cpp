// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/line_reader.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace hedgehog::server {
namespace {

constexpr std::size_t kLimit = 64;

/// Every line read, "TOO LONG" for one above the limit.
std::vector<std::string> read(const std::vector<std::string>& pieces) {
  LineReader reader(kLimit);
  std::vector<std::string> lines;
  for (const std::string& piece : pieces) {
    reader.feed(piece);
    while (const auto line = reader.next())
      lines.push_back(line->too_long ? "TOO LONG" : std::string(line->text));
  }
  return lines;
}

TEST(LineReader, EndsLinesAtLfAndAcceptsCrlfToo) {
  EXPECT_EQ(read({"a\nb\r\n\nc"}), (std::vector<std::string>{"a", "b", ""}));
}

TEST(LineReader, JoinsPieces) {
  EXPECT_EQ(read({"he", "ll", "o\r", "\nyou\n"}), (std::vector<std::string>{"hello", "you"}));
}

TEST(LineReader, ALineOfExactlyTheLimitPasses) {
  const std::string line(kLimit, 'x');
  EXPECT_EQ(read({line + "\n" + line + "\r\n"}), (std::vector<std::string>{line, line}));
  EXPECT_EQ(read({line, "\r", "\n"}), (std::vector<std::string>{line}));
  EXPECT_EQ(read({line + "x\nok\n"}), (std::vector<std::string>{"TOO LONG", "ok"}));
}

TEST(LineReader, ReportsALineThatIsTooLongOnceAndBeforeItsEnd) {
  const std::string piece(kLimit, 'x');
  EXPECT_EQ(read({piece, piece, piece}), (std::vector<std::string>{"TOO LONG"}));
  EXPECT_EQ(read({piece, piece, piece, "\nnext\n"}),
            (std::vector<std::string>{"TOO LONG", "next"}));
}

TEST(LineReader, ReturnsTheFirstByteThatIsNoLineEnd) {
  LineReader reader(kLimit);
  EXPECT_FALSE(reader.first_byte());
  reader.feed("\r\n");
  EXPECT_FALSE(reader.first_byte());
  while (reader.next()) {
  }
  reader.feed("POST");
  EXPECT_EQ(reader.first_byte(), 'P');
}

RC_GTEST_PROP(LineReader, IsIndependentOfThePacketBoundaries, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', 'b', '\n', '\r'));
  const auto cuts = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 9));
  std::vector<std::string> pieces;
  std::string rest = text;
  for (const int cut : cuts) {
    pieces.push_back(rest.substr(0, static_cast<std::size_t>(cut)));
    rest.erase(0, static_cast<std::size_t>(cut));
  }
  pieces.push_back(rest);
  RC_ASSERT(read(pieces) == read({text}));
}

}  // namespace
}  // namespace hedgehog::server
