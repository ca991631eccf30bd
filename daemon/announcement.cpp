// SPDX-License-Identifier: MIT
#include "daemon/announcement.h"

#include <poll.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <string_view>
#include <system_error>

namespace hedgehog::daemon {
namespace {

constexpr const char* kAvahi = "org.freedesktop.Avahi";
constexpr const char* kEntryGroup = "org.freedesktop.Avahi.EntryGroup";
constexpr std::chrono::milliseconds kRetry{10'000};
/// Timeout of one call, which may delay the shutdown.
constexpr std::chrono::microseconds kCallTimeout{1'000'000};
/// Maximum number of attempted names, "name #2" and so on.
constexpr int kMaxNames = 32;
/// AvahiEntryGroupState.
constexpr std::int32_t kCollision = 3;
constexpr std::int32_t kFailure = 4;

struct BusDeleter {
  void operator()(sd_bus* bus) const { sd_bus_flush_close_unref(bus); }
};
struct MessageDeleter {
  void operator()(sd_bus_message* message) const { sd_bus_message_unref(message); }
};
using Bus = std::unique_ptr<sd_bus, BusDeleter>;
using Message = std::unique_ptr<sd_bus_message, MessageDeleter>;

class BusError {
 public:
  BusError() = default;
  BusError(const BusError&) = delete;
  BusError& operator=(const BusError&) = delete;
  ~BusError() { sd_bus_error_free(&error_); }
  sd_bus_error* out() { return &error_; }
  bool is_collision() const {
    return sd_bus_error_has_name(&error_, "org.freedesktop.Avahi.CollisionError") != 0;
  }
  std::string text(int code) const {
    return error_.message != nullptr ? error_.message
                                     : std::generic_category().message(std::abs(code));
  }

 private:
  sd_bus_error error_{};
};

/// One connection to the bus with one Avahi entry group.
class EntryGroup {
 public:
  explicit EntryGroup(const AnnouncedService& service) : service_(service) {}

  /// Empty: announced as `name()`. Otherwise the reason of the failure.
  std::string open() {
    sd_bus* bus = nullptr;
    if (const int code = sd_bus_open_system(&bus); code < 0)
      return "there is no system bus: " + std::generic_category().message(-code);
    bus_.reset(bus);
    sd_bus_set_method_call_timeout(bus, kCallTimeout.count());
    sd_bus_match_signal(bus, nullptr, nullptr, nullptr, kEntryGroup, "StateChanged", on_state,
                        this);
    sd_bus_add_match(bus, nullptr,
                     "type='signal',sender='org.freedesktop.DBus',member='NameOwnerChanged',"
                     "arg0='org.freedesktop.Avahi'",
                     on_owner, this);
    BusError error;
    sd_bus_message* request = nullptr;
    sd_bus_message* reply = nullptr;
    int code = sd_bus_message_new_method_call(bus, &request, kAvahi, "/",
                                              "org.freedesktop.Avahi.Server", "EntryGroupNew");
    const Message sent(request);
    // Does not start an Avahi that was stopped by an administrator.
    if (code >= 0) code = sd_bus_message_set_auto_start(request, 0);
    if (code >= 0) code = sd_bus_call(bus, request, 0, error.out(), &reply);
    if (code < 0) return "Avahi does not respond: " + error.text(code);
    const Message owned(reply);
    const char* path = nullptr;
    if (sd_bus_message_read(reply, "o", &path) < 0) return "Avahi's response is not understood";
    path_ = path;
    return add();
  }

  const std::string& name() const noexcept { return name_; }

  /// Returns when Avahi or the bus has disconnected (true) or `stop` is readable (false). After a
  /// later collision on the network the next name is used.
  bool serve(int stop) {
    while (!lost_) {
      int handled = 0;
      while ((handled = sd_bus_process(bus_.get(), nullptr)) > 0) {
      }
      if (handled < 0 || lost_) return true;
      if (collided_ && !add().empty()) return true;
      pollfd waiting[] = {{sd_bus_get_fd(bus_.get()), POLLIN, 0}, {stop, POLLIN, 0}};
      ::poll(waiting, 2, -1);
      if (waiting[1].revents != 0) return false;
    }
    return true;
  }

 private:
  std::string add() {
    std::string failure = "every name is taken";
    while (tried_ < kMaxNames) {
      collided_ = false;
      name_ = service_.name + (++tried_ == 1 ? "" : " #" + std::to_string(tried_));
      BusError error;
      const int code = add_service(error);
      if (code >= 0) return {};
      failure = "Avahi refuses the service: " + error.text(code);
      if (!error.is_collision()) return failure;
    }
    return failure;
  }

  int add_service(BusError& error) {
    sd_bus_call_method(bus_.get(), kAvahi, path_.c_str(), kEntryGroup, "Reset", nullptr, nullptr,
                       "");
    sd_bus_message* request = nullptr;
    int code = sd_bus_message_new_method_call(bus_.get(), &request, kAvahi, path_.c_str(),
                                              kEntryGroup, "AddService");
    if (code < 0) return code;
    const Message owned(request);
    // Every interface and protocol (-1), the default domain and host ("").
    code = sd_bus_message_append(request, "iiussssq", -1, -1, 0u, name_.c_str(), "_hedgehog._tcp",
                                 "", "", service_.port);
    if (code >= 0) code = sd_bus_message_open_container(request, 'a', "ay");
    for (const std::string& record : txt_records(service_))
      if (code >= 0) code = sd_bus_message_append_array(request, 'y', record.data(), record.size());
    if (code >= 0) code = sd_bus_message_close_container(request);
    if (code >= 0) code = sd_bus_call(bus_.get(), request, 0, error.out(), nullptr);
    if (code < 0) return code;
    return sd_bus_call_method(bus_.get(), kAvahi, path_.c_str(), kEntryGroup, "Commit", error.out(),
                              nullptr, "");
  }

  static int on_state(sd_bus_message* message, void* self, sd_bus_error*) {
    auto& group = *static_cast<EntryGroup*>(self);
    std::int32_t state = 0;
    if (sd_bus_message_read(message, "i", &state) < 0 ||
        group.path_ != sd_bus_message_get_path(message))
      return 0;
    group.collided_ = group.collided_ || state == kCollision;
    group.lost_ = group.lost_ || state == kFailure;
    return 0;
  }

  static int on_owner(sd_bus_message*, void* self, sd_bus_error*) {
    static_cast<EntryGroup*>(self)->lost_ = true;
    return 0;
  }

  const AnnouncedService& service_;
  Bus bus_;
  std::string path_;
  std::string name_;
  int tried_ = 0;
  bool collided_ = false;
  bool lost_ = false;
};

bool is_loopback(std::string_view host) {
  return host.starts_with("127.") || host == "[::1]" || host == "localhost";
}

}  // namespace

std::optional<std::uint16_t> announced_port(const std::vector<std::string>& addresses) {
  constexpr std::string_view kTls = "tls://";
  for (std::string_view address : addresses) {
    if (!address.starts_with(kTls)) continue;
    address.remove_prefix(kTls.size());
    const std::size_t colon = address.rfind(':');
    if (colon == address.npos || is_loopback(address.substr(0, colon))) continue;
    std::uint16_t port = 0;
    std::from_chars(address.data() + colon + 1, address.data() + address.size(), port);
    if (port != 0) return port;
  }
  return std::nullopt;
}

std::vector<std::string> txt_records(const AnnouncedService& service) {
  std::vector<std::string> records{"protocol=" + service.protocol};
  if (!service.serial.empty()) records.push_back("serial=" + service.serial);
  records.emplace_back("tls=1");
  return records;
}

Announcement::Announcement(AnnouncedService service)
    : service_(std::move(service)), stop_(::eventfd(0, EFD_CLOEXEC)), thread_([this] { run(); }) {}

Announcement::~Announcement() {
  ::eventfd_write(stop_, 1);
  thread_.join();
  ::close(stop_);
}

void Announcement::run() {
  std::string reported;
  for (;;) {
    {
      EntryGroup group(service_);
      const std::string failure = group.open();
      const std::string line =
          failure.empty() ? "announced on the network as \"" + group.name() + "\" (_hedgehog._tcp)"
                          : "not announced on the network: " + failure;
      if (line != reported) spdlog::info("{}", line);
      reported = line;
      if (failure.empty() && !group.serve(stop_)) return;
    }
    pollfd waiting{stop_, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(kRetry.count())) > 0) return;
  }
}

}  // namespace hedgehog::daemon
