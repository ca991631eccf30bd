// SPDX-License-Identifier: MIT
#include "tests/vm/event_node.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hedgehog::vm {
namespace {

constexpr int kEventTimeoutMs = 60'000;
constexpr std::size_t kWordBits = sizeof(unsigned long) * CHAR_BIT;

}  // namespace

std::string event_node(const std::string& name) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/sys/class/input", none)) {
    const std::string file = entry.path().filename();
    if (!file.starts_with("event")) continue;
    std::string shown;
    std::getline(std::ifstream(entry.path() / "device/name"), shown);
    if (shown == name) return "/dev/input/" + file;
  }
  return {};
}

EventNode::EventNode(const std::string& path)
    : fd_(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC)) {
  if (fd_ < 0) throw std::runtime_error("'" + path + "': " + std::strerror(errno));
}

bool EventNode::has(int type, int code) const {
  std::array<unsigned long, KEY_CNT / kWordBits + 1> bits{};
  if (::ioctl(fd_, EVIOCGBIT(type, sizeof bits), bits.data()) < 0) return false;
  const auto at = static_cast<std::size_t>(code);
  return (bits[at / kWordBits] >> (at % kWordBits) & 1) != 0;
}

input_absinfo EventNode::axis(int code) const {
  input_absinfo info{};
  ::ioctl(fd_, EVIOCGABS(code), &info);
  return info;
}

int EventNode::upload(ff_effect& effect) const {
  return ::ioctl(fd_, EVIOCSFF, &effect) < 0 ? errno : 0;
}

int EventNode::erase(int id) const { return ::ioctl(fd_, EVIOCRMFF, id) < 0 ? errno : 0; }

void EventNode::write(std::uint16_t code, int value) const {
  input_event event{};
  event.type = EV_FF;
  event.code = code;
  event.value = value;
  if (::write(fd_, &event, sizeof event) != sizeof event)
    throw std::runtime_error(std::string("an event node takes no event: ") + std::strerror(errno));
}

std::optional<input_event> EventNode::next() const {
  input_event event{};
  pollfd waiting{fd_, POLLIN, 0};
  if (::poll(&waiting, 1, kEventTimeoutMs) != 1 ||
      ::read(fd_, &event, sizeof event) != sizeof event)
    return std::nullopt;
  return event;
}

void EventNode::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

}  // namespace hedgehog::vm
