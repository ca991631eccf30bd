// SPDX-License-Identifier: MIT
// Announces the daemon on the network as _hedgehog._tcp (DNS-SD) through Avahi.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace hedgehog::daemon {

struct AnnouncedService {
  /// The ball's name; Avahi changes it to "name #2" if it already exists on the network.
  std::string name;
  std::uint16_t port = 0;
  /// Serial number of the board; empty: none is configured.
  std::string serial;
  std::string protocol;
};

/// The port of the first of `addresses` ("192.0.2.7:7586", "[2001:db8::7]:7586", "/a/socket",
/// "http://…", as reported by the listener) that other machines can reach; nullopt: none.
std::optional<std::uint16_t> announced_port(const std::vector<std::string>& addresses);

/// The TXT records: protocol, serial if there is one, and tls=1, because a daemon that other
/// machines can reach has no listener without TLS.
std::vector<std::string> txt_records(const AnnouncedService& service);

/// Announces on its own thread until it is destroyed; Avahi withdraws the announcement when the
/// connection to the bus ends, also that of a killed daemon. Without a bus or Avahi it retries
/// every ten seconds. Reports its state to the log once per change.
class Announcement {
 public:
  explicit Announcement(AnnouncedService service);
  Announcement(const Announcement&) = delete;
  Announcement& operator=(const Announcement&) = delete;
  ~Announcement();

 private:
  void run();

  AnnouncedService service_;
  /// An eventfd that becomes readable when the thread has to end.
  int stop_;
  std::thread thread_;
};

}  // namespace hedgehog::daemon
