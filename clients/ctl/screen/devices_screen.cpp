// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/devices_screen.h"

#include <algorithm>
#include <sstream>

#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {
namespace {

constexpr std::size_t kNoEdge = std::string::npos;
constexpr std::size_t kNameAt = 24;
constexpr std::size_t kUseAt = 52;

std::string use_words(const std::string& use, const std::string& ball) {
  if (use == "board") return "is " + ball;
  if (use == "imu") return "is its orientation";
  return "is its second " + use;
}

std::string full_name(const protocol::SeenDevice& device) {
  std::string name = device.name;
  if (device.serial) name += " " + *device.serial;
  if (device.firmware) name += ", firmware " + *device.firmware;
  if (device.protocol) name += ", protocol " + *device.protocol;
  return name;
}

/// Appends `text` to the last of `lines`, wrapped at `width`; continuation lines are indented by
/// `indent`.
void append_wrapped(std::vector<std::string>& lines, const std::string& text, std::size_t indent,
                    std::size_t width) {
  std::istringstream words(text);
  bool first = true;
  for (std::string word; words >> word; first = false) {
    if (columns(lines.back()) + 1 + columns(word) > width && columns(lines.back()) > indent) {
      lines.emplace_back(indent, ' ');
      first = true;
    }
    lines.back() += (first ? "" : " ") + word;
  }
}

void append_device(std::vector<std::string>& lines, const protocol::SeenDevice& device,
                   const std::string& ball, std::size_t width) {
  lines.push_back(left("  " + left(device.path, 10) + " " + device.ids, kNameAt));
  const std::string name = full_name(device);
  const std::string use =
      device.use ? use_words(*device.use, ball) : "not used: " + device.why_not.value_or("");
  const bool beside = width == kNoEdge || (columns(name) + 2 <= kUseAt - kNameAt &&
                                           (!device.use || columns(use) <= width - kUseAt));
  if (beside) {
    lines.back() += left(name + "  ", kUseAt - kNameAt);
    append_wrapped(lines, use, kNameAt, width);
    return;
  }
  append_wrapped(lines, name, kNameAt, width);
  lines.emplace_back(kNameAt, ' ');
  append_wrapped(lines, use, kNameAt, width);
}

}  // namespace

std::vector<std::string> devices_screen(const protocol::DevicesResult& seen,
                                        const std::string& ball, const ScreenStyle& style) {
  const std::size_t width = style.cuts ? style.columns : kNoEdge;
  std::vector<std::string> lines;
  for (const protocol::SeenDevice& device : seen.devices) append_device(lines, device, ball, width);
  for (const protocol::MissingDevice& missing : seen.missing) {
    lines.push_back(left("  missing", kNameAt));
    append_wrapped(lines, missing.use + ": " + missing.why, kNameAt, width);
  }
  if (lines.empty()) lines.emplace_back("  no supported device is connected");
  if (seen.others > 0)
    lines.push_back("  and " + std::to_string(seen.others) + " more that hedgehogd does not use");
  return lines;
}

}  // namespace hedgehog::client
