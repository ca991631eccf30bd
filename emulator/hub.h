// SPDX-License-Identifier: MIT
// The emulated devices by name, which of them are plugged in, and the commands that change that.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "emulator/gadget.h"
#include "emulator/host_session.h"
#include "emulator/vhci.h"

namespace hedgehog::emulator {

/// The emulator's thread.
class Hub {
 public:
  /// With `vhci` a plug attaches to this machine; without, hosts come and import.
  explicit Hub(std::optional<Vhci> vhci) : vhci_(std::move(vhci)) {}

  /// False: there is one of that name.
  bool add(const std::string& name, std::unique_ptr<Gadget> gadget);
  bool empty() const noexcept { return devices_.empty(); }

  /// A command line, without its end; the answer, without its end: "ok", an object, or "error:
  /// ...".
  std::string execute(const std::string& line);
  bool over() const noexcept { return over_; }

  /// A millisecond for every device.
  void step();
  /// Every open talk, for poll. Those that are over are forgotten by `tidy`.
  void each_session(const std::function<void(HostSession&)>& visit);
  void tidy();

  /// For hosts that import: what is plugged in, and one of it, by its bus id. `import` refuses what
  /// another host has.
  std::vector<Exported> exported() const;
  std::optional<Exported> importable(const std::string& bus_id) const;
  void import(const std::string& bus_id, device::FileDescriptor socket);

 private:
  struct Device {
    std::string name;
    std::unique_ptr<Gadget> gadget;
    bool plugged = false;
    int port = -1;  // of vhci
    std::unique_ptr<HostSession> session;
  };
  Device* find(const std::string& name);
  Exported exported(std::size_t index) const;
  std::string execute(Device& device, std::span<const std::string> words);
  std::string plug(Device& device);
  std::string unplug(Device& device, bool cut);
  std::string list() const;

  std::optional<Vhci> vhci_;
  std::vector<Device> devices_;
  bool over_ = false;
};

}  // namespace hedgehog::emulator
