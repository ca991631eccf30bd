// SPDX-License-Identifier: MIT
#include "clients/common/ascii_output.h"

#include <unistd.h>
#include <ext/stdio_sync_filebuf.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <utility>

#include "clients/common/terminal.h"
#include "clients/common/text.h"

namespace hedgehog::client {

namespace {

/// Longer sequences first: the first match is used.
constexpr std::array<std::pair<std::string_view, std::string_view>, 25> kInAscii{{
    {"°C", "C"}, {"°", " deg"}, {"µ", "u"},  {"·", "-"},  {"…", "..."}, {"–", "-"}, {"−", "-"},
    {"×", "x"},  {"±", "+/-"},  {"→", "->"}, {"▲", "^"},  {"∘", "o"},   {"○", "O"}, {"●", "@"},
    {"━", "="},  {"─", "-"},    {"╋", "|"},  {"┊", "|"},  {"│", "|"},   {"┤", "|"}, {"└", "+"},
    {"█", "#"},  {"░", "."},    {"≤", "<="}, {"≥", ">="},
}};

/// Number of bytes at the end of `text` that may be part of a sequence continued by the next write:
/// an incomplete character, or "°".
std::size_t open_end(std::string_view text) {
  std::size_t last = text.size();
  while (last > 0 && !begins_character(text[last - 1])) --last;
  if (last == 0) return 0;
  const auto first_byte = static_cast<unsigned char>(text[last - 1]);
  const std::size_t bytes = first_byte >= 0xF0   ? 4
                            : first_byte >= 0xE0 ? 3
                            : first_byte >= 0xC0 ? 2
                                                 : 1;
  const std::size_t there = text.size() - (last - 1);
  return there < bytes || text.substr(last - 1) == "°" ? there : 0;
}

struct AsciiStream {
  int descriptor = -1;
  std::string begun{};
};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

ssize_t write_ascii(void* cookie, const char* bytes, std::size_t size) {
  AsciiStream& stream = *static_cast<AsciiStream*>(cookie);
  std::string text = stream.begun + std::string(bytes, size);
  stream.begun = text.substr(text.size() - open_end(text));
  text.resize(text.size() - stream.begun.size());
  return write_all(stream.descriptor, in_ascii(text)) ? static_cast<ssize_t>(size) : 0;
}

int close_ascii(void* cookie) {
  const AsciiStream& stream = *static_cast<AsciiStream*>(cookie);
  return write_all(stream.descriptor, in_ascii(stream.begun)) ? 0 : EOF;
}

std::FILE* open_ascii(AsciiStream& stream, std::FILE* instead, int buffering) {
  std::FILE* file = ::fopencookie(
      &stream, "w", {.read = nullptr, .write = write_ascii, .seek = nullptr, .close = close_ascii});
  if (file == nullptr) return instead;
  std::fflush(instead);
  std::setvbuf(file, nullptr, buffering, BUFSIZ);
  return file;
}

}  // namespace

std::string in_ascii(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    bool known = false;
    for (const auto& [character, ascii] : kInAscii) {
      if (!text.starts_with(character)) continue;
      out += ascii;
      text.remove_prefix(character.size());
      known = true;
      break;
    }
    if (known) continue;
    out += text.front();
    text.remove_prefix(1);
  }
  return out;
}

void print_in_ascii() {
  // Never destroyed: written to at the exit of the program.
  static auto& out = *new AsciiStream{STDOUT_FILENO};
  static auto& error = *new AsciiStream{STDERR_FILENO};
  stdout = open_ascii(out, stdout, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF);
  stderr = open_ascii(error, stderr, _IONBF);
  using Buffer = __gnu_cxx::stdio_sync_filebuf<char>;
  std::cout.rdbuf(new Buffer(stdout));
  std::cerr.rdbuf(new Buffer(stderr));
}

void print_as_the_locale_allows(std::span<const std::string> arguments) {
  const auto is_for_programs = [](const std::string& word) {
    return word == "--json" || word == "--csv";
  };
  if (terminal_traits().ascii && std::ranges::none_of(arguments, is_for_programs)) print_in_ascii();
}

}  // namespace hedgehog::client
