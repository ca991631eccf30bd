// SPDX-License-Identifier: MIT
#include "tests/vm/screen.h"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "tests/folders.h"

namespace hedgehog::vm {
namespace {

constexpr const char* kDisplay = ":9";
// The line that Xvfb writes once it serves; its socket exists before its frame buffer.
constexpr const char* kServing = "\n9\n";
constexpr const char* kFrameBuffer = "Xvfb_screen0";
constexpr std::size_t kPixelBytes = 4;
constexpr std::size_t kPictureBytes = kPixelBytes * Screen::kWidth * Screen::kHeight;
// Minimum visible difference, of a colour's 256 steps.
constexpr int kVisible = 24;
// Every seventh pixel is compared, in a different column of each row.
constexpr std::size_t kSample = 7;

bool is_lit(const Picture& picture, std::size_t at) {
  return picture[at] != 0 || picture[at + 1] != 0 || picture[at + 2] != 0;
}

bool differs(const Picture& one, const Picture& other, std::size_t at) {
  for (std::size_t i = at; i < at + 3; ++i)
    if (std::abs(static_cast<std::uint8_t>(one[i]) - static_cast<std::uint8_t>(other[i])) >=
        kVisible)
      return true;
  return false;
}

bool is_serving(const std::string& output) {
  return ("\n" + output).find(kServing) != std::string::npos;
}

/// Share of the sampled pixels for which `is` holds.
template <class Is>
double share(Is is) {
  std::size_t count = 0;
  std::size_t all = 0;
  for (std::size_t at = 0; at < kPictureBytes; at += kSample * kPixelBytes, ++all)
    if (is(at)) ++count;
  return static_cast<double>(count) / static_cast<double>(all);
}

}  // namespace

double changed_share(const Picture& before, const Picture& after) {
  return share([&](std::size_t at) { return differs(before, after, at); });
}

double lit_share(const Picture& picture) {
  return share([&](std::size_t at) { return is_lit(picture, at); });
}

Screen::Screen(const Home& home)
    : home_(home),
      server_({"/usr/bin/Xvfb", kDisplay, "-screen", "0",
               std::to_string(kWidth) + "x" + std::to_string(kHeight) + "x24", "-fbdir",
               home.path(""), "-nolisten", "tcp", "-displayfd", "1"},
              home.environment(), home.path("screen")) {
  const bool serves =
      eventually([&] { return is_serving(home.read("screen")) || server_.ended(); }, 50);
  if (!serves || server_.ended())
    throw std::runtime_error("Xvfb does not start: " + home.read("screen"));
}

std::string Screen::display() { return std::string("DISPLAY=") + kDisplay; }

Picture Screen::picture() const {
  // XWD: a header and a colour table, then the pixels to the end of the file.
  const std::string file = home_.read(kFrameBuffer);
  if (file.size() < kPictureBytes) throw std::runtime_error("Xvfb has no picture");
  return file.substr(file.size() - kPictureBytes);
}

std::string Screen::close_windows() const {
  const std::string script = source_folder() + "/tests/vm/close_windows.py";
  return shell(display() + " /usr/bin/python3 " + script);
}

}  // namespace hedgehog::vm
