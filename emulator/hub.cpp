// SPDX-License-Identifier: MIT
#include "emulator/hub.h"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <exception>
#include <system_error>
#include <utility>

#include "emulator/words.h"

namespace hedgehog::emulator {
namespace {

constexpr unsigned kBus = 1;
constexpr int kMaxStalls = 1000;

std::optional<std::uint8_t> endpoint_address(const std::string& text) {
  std::uint8_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  const bool good = error == std::errc() && end == text.data() + text.size() &&
                    (value & 0x0F) != 0 && (value & 0x70) == 0;
  return good ? std::optional(value) : std::nullopt;
}

}  // namespace

bool Hub::add(const std::string& name, std::unique_ptr<EmulatedDevice> emulated) {
  if (find(name) != nullptr) return false;
  devices_.push_back({name, std::move(emulated), false, -1, nullptr});
  return true;
}

Hub::Device* Hub::find(const std::string& name) {
  const auto found = std::find_if(devices_.begin(), devices_.end(),
                                  [&name](const Device& device) { return device.name == name; });
  return found == devices_.end() ? nullptr : &*found;
}

std::string Hub::execute(const std::string& line) {
  const std::vector<std::string> words = split(line, ' ');
  if (words.empty()) return "error: no command";
  if (words[0] == "list") return list();
  if (words[0] == "quit") {
    over_ = true;
    return "ok";
  }
  if (words.size() < 2) return "error: COMMAND DEVICE ...";
  Device* device = find(words[1]);
  if (device == nullptr) return "error: no device " + words[1];
  std::vector<std::string> rest{words[0]};
  rest.insert(rest.end(), words.begin() + 2, words.end());
  try {
    return execute(*device, rest);
  } catch (const std::exception& e) {
    return std::string("error: ") + e.what();
  }
}

std::string Hub::execute(Device& device, std::span<const std::string> words) {
  EmulatedDevice& emulated = *device.emulated;
  const std::string& verb = words[0];
  if (verb == "plug" && words.size() == 1) return plug(device);
  if (verb == "unplug" && words.size() == 1) return unplug(device, false);
  if (verb == "cut" && words.size() == 1) return unplug(device, true);
  if (verb == "status" && words.size() == 1) return emulated.status();
  if (verb == "silence" && words.size() == 2 && (words[1] == "on" || words[1] == "off")) {
    emulated.set_silent(words[1] == "on");
    return "ok";
  }
  if (verb == "stall" && (words.size() == 2 || words.size() == 3)) {
    const auto address = endpoint_address(words[1]);
    const auto times = number<int>(words.size() == 3 ? words[2] : "1");
    if (!address || !times || *times < 1 || *times > kMaxStalls)
      return "error: stall DEVICE ENDPOINT [TIMES], as in `stall board 81 3`";
    emulated.halt(*address, *times);
    return "ok";
  }
  return emulated.command(words).value_or("error: " + device.name + " has no command " + verb);
}

std::string Hub::plug(Device& device) {
  if (device.plugged) return "error: " + device.name + " is plugged in already";
  if (vhci_) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::system_error(errno, std::generic_category(), "socketpair");
    device::FileDescriptor ours(ends[0]);
    const device::FileDescriptor kernels(ends[1]);
    const auto index = static_cast<unsigned>(&device - devices_.data());
    device.port = vhci_->attach(kernels.get(), kBus << 16 | (index + 1));
    device.session = std::make_unique<HostSession>(*device.emulated, std::move(ours));
  }
  device.plugged = true;
  return "ok";
}

std::string Hub::unplug(Device& device, bool cut) {
  if (!device.plugged) return "error: " + device.name + " is not plugged in";
  device.plugged = false;
  // A cut closes the socket without detaching; the kernel frees the port by itself.
  if (vhci_ && !cut) vhci_->detach(device.port);
  device.session.reset();
  device.emulated->unplugged();
  return "ok";
}

std::string Hub::list() const {
  std::string text = "[";
  for (const Device& device : devices_) {
    if (text.size() > 1) text += ", ";
    text += R"({"name": ")" + device.name + R"(", "device": ")" + device.emulated->product_name() +
            R"(", "serial": ")" + device.emulated->serial() + R"(", "plugged": )" +
            (device.plugged ? "true" : "false") + "}";
  }
  return text + "]";
}

void Hub::step() {
  for (Device& device : devices_) {
    device.emulated->step();
    if (device.session) device.session->pump();
  }
}

void Hub::each_session(const std::function<void(HostSession&)>& visit) {
  for (Device& device : devices_)
    if (device.session) visit(*device.session);
}

void Hub::tidy() {
  for (Device& device : devices_) {
    if (!device.session || device.session->open()) continue;
    device.session.reset();
    device.emulated->unplugged();
    // The host closed the connection. Without vhci another host may import the device.
    if (vhci_) device.plugged = false;
  }
}

Exported Hub::exported(std::size_t index) const {
  Exported made = devices_[index].emulated->exported();
  made.bus = kBus;
  made.address = static_cast<std::uint32_t>(index) + 1;
  made.bus_id = std::to_string(kBus) + "-" + std::to_string(index + 1);
  return made;
}

std::vector<Exported> Hub::exported() const {
  std::vector<Exported> found;
  for (std::size_t i = 0; i < devices_.size(); ++i)
    if (devices_[i].plugged && !devices_[i].session) found.push_back(exported(i));
  return found;
}

std::optional<Exported> Hub::importable(const std::string& bus_id) const {
  const auto all = exported();
  const auto found = std::find_if(all.begin(), all.end(), [&bus_id](const Exported& device) {
    return device.bus_id == bus_id;
  });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

void Hub::import(const std::string& bus_id, device::FileDescriptor socket) {
  const auto device = importable(bus_id);
  if (!device) return;
  Device& wanted = devices_[device->address - 1];
  wanted.session = std::make_unique<HostSession>(*wanted.emulated, std::move(socket));
}

}  // namespace hedgehog::emulator
