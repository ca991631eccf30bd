// SPDX-License-Identifier: MIT
#include "emulator/vhci.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "daemon/device/socket_transport.h"

namespace hedgehog::emulator {
namespace {

constexpr int kFullSpeed = 2;
constexpr int kFree = 4;

}  // namespace

int Vhci::free_port() const {
  // Columns: hub port state speed device socket bus-id; one line per port below a header line.
  std::ifstream in(folder_ + "/status");
  if (!in)
    throw std::runtime_error(folder_ + ": no such controller; load it with `modprobe vhci-hcd`");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string hub;
    int port = 0;
    int state = 0;
    if (words >> hub >> port >> state && hub == "hs" && state == kFree) return port;
  }
  throw std::runtime_error(folder_ + ": all of its ports are taken");
}

void Vhci::write(const std::string& file, const std::string& text) const {
  const std::string path = folder_ + "/" + file;
  const device::FileDescriptor out(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  const auto size = static_cast<ssize_t>(text.size());
  if (out.get() < 0 || ::write(out.get(), text.data(), text.size()) != size)
    throw std::system_error(errno, std::generic_category(), path);
}

int Vhci::attach(int socket, unsigned device_id) const {
  const int port = free_port();
  std::ostringstream line;
  line << port << ' ' << socket << ' ' << device_id << ' ' << kFullSpeed;
  write("attach", line.str());
  return port;
}

void Vhci::detach(int port) const { write("detach", std::to_string(port)); }

}  // namespace hedgehog::emulator
