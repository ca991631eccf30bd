// SPDX-License-Identifier: MIT
// The emulated devices by name, their plug state, and the commands that change it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "emulator/emulated_device.h"
#include "emulator/host_session.h"
#include "emulator/vhci.h"

namespace hedgehog::emulator {

/// The emulator's thread.
class Hub {
 public:
  /// With `vhci`, plugging attaches a device to this machine; without, hosts import it.
  explicit Hub(std::optional<Vhci> vhci) : vhci_(std::move(vhci)) {}

  /// False: the name is in use.
  bool add(const std::string& name, std::unique_ptr<EmulatedDevice> emulated);
  bool empty() const noexcept { return devices_.empty(); }

  /// Executes a command line; returns "ok", a JSON object, or "error: ...". Both without LF.
  std::string execute(const std::string& line);
  bool over() const noexcept { return over_; }

  /// Advances every device by one millisecond.
  void step();
  /// Visits every session, for poll. `tidy` removes closed ones.
  void each_session(const std::function<void(HostSession&)>& visit);
  void tidy();

  /// For importing hosts: available devices, and one of them by bus id. `import` ignores a device
  /// that another host has imported.
  std::vector<Exported> exported() const;
  std::optional<Exported> importable(const std::string& bus_id) const;
  void import(const std::string& bus_id, device::FileDescriptor socket);

 private:
  struct Device {
    std::string name;
    std::unique_ptr<EmulatedDevice> emulated;
    bool plugged = false;
    int port = -1;  // vhci port
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
