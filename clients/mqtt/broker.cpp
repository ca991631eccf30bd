// SPDX-License-Identifier: MIT
#include "clients/mqtt/broker.h"

#include <mosquitto.h>
#include <mqtt_protocol.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <set>
#include <thread>

#include "clients/lib/backoff.h"
#include "clients/lib/line_socket.h"

namespace hedgehog::mqtt {

namespace {

constexpr std::chrono::milliseconds kLoopWait{500};
/// Time for the last message to reach the broker.
constexpr std::chrono::seconds kStopTimeout{2};
constexpr const char* kSystemCertificates = "/etc/ssl/certs";

/// Properties in libmosquitto's format; freed by the destructor.
class Properties {
 public:
  Properties() = default;
  ~Properties() { mosquitto_property_free_all(&list_); }
  Properties(const Properties&) = delete;
  Properties& operator=(const Properties&) = delete;

  void add(int identifier, const std::string& text) {
    (void)mosquitto_property_add_string(&list_, identifier, text.c_str());
  }
  void add_bytes(int identifier, const std::string& bytes) {
    (void)mosquitto_property_add_binary(&list_, identifier, bytes.data(),
                                        static_cast<std::uint16_t>(bytes.size()));
  }
  void add_user(const std::string& name, const std::string& value) {
    (void)mosquitto_property_add_string_pair(&list_, MQTT_PROP_USER_PROPERTY, name.c_str(),
                                             value.c_str());
  }
  const mosquitto_property* list() const noexcept { return list_; }
  /// Transfers the ownership of the list to the caller.
  mosquitto_property* release() noexcept { return std::exchange(list_, nullptr); }

 private:
  mosquitto_property* list_ = nullptr;
};

void describe(Properties& properties, const BrokerOptions& options, const Message& message) {
  if (message.payload.starts_with('{')) properties.add(MQTT_PROP_CONTENT_TYPE, "application/json");
  if (!message.correlation.empty())
    properties.add_bytes(MQTT_PROP_CORRELATION_DATA, message.correlation);
  for (const auto& [name, value] : options.properties) properties.add_user(name, value);
}

int qos_of(Delivery delivery) noexcept { return delivery == Delivery::kQos1 ? 1 : 0; }

Message message_of(const mosquitto_message& arrived, const mosquitto_property* properties) {
  Message message;
  message.topic = arrived.topic;
  if (arrived.payloadlen > 0)
    message.payload.assign(static_cast<const char*>(arrived.payload),
                           static_cast<std::size_t>(arrived.payloadlen));
  char* topic = nullptr;
  if (mosquitto_property_read_string(properties, MQTT_PROP_RESPONSE_TOPIC, &topic, false) !=
      nullptr) {
    message.response_topic = topic;
    std::free(topic);
  }
  void* data = nullptr;
  std::uint16_t size = 0;
  if (mosquitto_property_read_binary(properties, MQTT_PROP_CORRELATION_DATA, &data, &size, false) !=
      nullptr) {
    message.correlation.assign(static_cast<const char*>(data), size);
    std::free(data);
  }
  return message;
}

}  // namespace

struct Broker::Impl {
  explicit Impl(BrokerOptions wanted) : options(std::move(wanted)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (client != nullptr) mosquitto_destroy(client);
    ::close(readable);
  }

  // The connection's thread; `mosquitto_loop_start` would end it at an invalid certificate.
  void run() {
    int done =
        mosquitto_connect_async(client, options.host.c_str(), options.port, options.keepalive_s);
    std::optional<client::Clock::time_point> stop_deadline;
    for (;;) {
      while (done == MOSQ_ERR_SUCCESS &&
             !(stop_deadline && client::Clock::now() > *stop_deadline)) {
        done = mosquitto_loop(client, static_cast<int>(kLoopWait.count()), 1);
        std::unique_lock lock(mutex);
        if (ending && !stop_deadline) stop_deadline = client::Clock::now() + kStopTimeout;
      }
      std::unique_lock lock(mutex);
      if (ending) return;
      if (!std::exchange(reported, false)) notify_locked(BrokerLost{mosquitto_strerror(done)});
      if (changed.wait_for(lock, backoff.next(), [this] { return ending; })) return;
      lock.unlock();
      done = mosquitto_reconnect_async(client);
    }
  }

  // Called by that thread.
  static void on_connect(mosquitto*, void* self, int reason, int, const mosquitto_property*) {
    auto& impl = *static_cast<Impl*>(self);
    if (reason == 0) impl.backoff.reset();
    impl.reported = reason != 0;
    impl.notify(reason == 0 ? BrokerNotice(BrokerConnected{})
                            : BrokerNotice(BrokerLost{mosquitto_reason_string(reason)}));
  }
  static void on_disconnect(mosquitto*, void* self, int reason, const mosquitto_property*) {
    auto& impl = *static_cast<Impl*>(self);
    {
      const std::lock_guard lock(impl.mutex);
      impl.in_flight[0].clear();
    }
    if (std::exchange(impl.reported, true)) return;
    // Reason codes of the protocol start at 128, lower ones are libmosquitto's own.
    impl.notify(
        BrokerLost{reason >= 128 ? mosquitto_reason_string(reason) : mosquitto_strerror(reason)});
  }
  static void on_publish(mosquitto*, void* self, int number, int, const mosquitto_property*) {
    auto& impl = *static_cast<Impl*>(self);
    const std::lock_guard lock(impl.mutex);
    for (auto& numbers : impl.in_flight) numbers.erase(number);
  }
  static void on_message(mosquitto*, void* self, const mosquitto_message* arrived,
                         const mosquitto_property* properties) {
    auto& impl = *static_cast<Impl*>(self);
    if (arrived->retain) return;
    if (static_cast<std::size_t>(arrived->payloadlen) > kMaxPayload) {
      ++impl.dropped;
      return;
    }
    impl.notify(message_of(*arrived, properties));
  }

  void notify(BrokerNotice notice) {
    const std::lock_guard lock(mutex);
    notify_locked(std::move(notice));
  }
  void notify_locked(BrokerNotice notice) {
    const auto* message = std::get_if<Message>(&notice);
    const bool urgent = message != nullptr && message->topic == options.urgent_topic;
    if (message != nullptr && notices.size() >= (urgent ? 2 : 1) * kMaxArrived) {
      ++dropped;
      return;
    }
    notices.insert(urgent ? notices.begin() : notices.end(), std::move(notice));
    ::eventfd_write(readable, 1);
  }

  BrokerOptions options;
  mosquitto* client = nullptr;
  int readable = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  std::thread thread;
  client::Backoff backoff;  // used by the thread only, like `reported`: a loss has been reported
  bool reported = false;
  std::atomic<std::uint64_t> dropped = 0;
  std::mutex mutex;  // for the following members
  std::condition_variable changed;
  bool ending = false;
  std::deque<BrokerNotice> notices;
  std::array<std::set<int>, 2> in_flight;  // by QoS: not received by the broker yet
};

Result<std::unique_ptr<Broker>> Broker::open(const BrokerOptions& options) {
  static const int kReady = mosquitto_lib_init();
  auto impl = std::make_unique<Impl>(options);
  if (kReady == MOSQ_ERR_SUCCESS)
    impl->client = mosquitto_new(options.client_id.c_str(), true, impl.get());
  mosquitto* client = impl->client;
  if (client == nullptr || impl->readable < 0)
    return Problem(EX_OSERR, "no MQTT client can be made: out of memory or descriptors");
  (void)mosquitto_int_option(client, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V5);
  (void)mosquitto_int_option(client, MOSQ_OPT_TCP_NODELAY, 1);
  (void)mosquitto_threaded_set(client, true);
  if (options.user)
    (void)mosquitto_username_pw_set(client, options.user->c_str(),
                                    options.password ? options.password->c_str() : nullptr);
  if (options.tls) {
    const bool of_system = options.ca_file.empty();
    const int done =
        mosquitto_tls_set(client, of_system ? nullptr : options.ca_file.c_str(),
                          of_system ? kSystemCertificates : nullptr, nullptr, nullptr, nullptr);
    if (done != MOSQ_ERR_SUCCESS)
      return Problem(EX_NOINPUT, options.ca_file + " cannot be read: it should hold certificates");
  }
  const Message& will = options.will;
  if (!will.topic.empty()) {
    Properties properties;
    describe(properties, options, will);
    (void)mosquitto_will_set_v5(client, will.topic.c_str(), static_cast<int>(will.payload.size()),
                                will.payload.data(), qos_of(will.delivery), will.retained,
                                properties.release());
  }
  mosquitto_connect_v5_callback_set(client, Impl::on_connect);
  mosquitto_disconnect_v5_callback_set(client, Impl::on_disconnect);
  mosquitto_publish_v5_callback_set(client, Impl::on_publish);
  mosquitto_message_v5_callback_set(client, Impl::on_message);
  impl->thread = std::thread([&self = *impl] { self.run(); });
  return std::unique_ptr<Broker>(new Broker(std::move(impl)));
}

Broker::Broker(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Broker::~Broker() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->ending = true;
  }
  impl_->changed.notify_all();
  // Also wakes the thread.
  (void)mosquitto_disconnect_v5(impl_->client, MQTT_RC_DISCONNECT_WITH_WILL_MSG, nullptr);
  impl_->thread.join();
}

bool Broker::publish(const Message& message) {
  const int qos = qos_of(message.delivery);
  Properties properties;
  describe(properties, impl_->options, message);
  // Held until the number is known: the acknowledgement may arrive earlier.
  const std::lock_guard lock(impl_->mutex);
  auto& numbers = impl_->in_flight[static_cast<std::size_t>(qos)];
  if (numbers.size() < (qos == 0 ? kMaxUnsent : kMaxKept)) {
    int number = 0;
    const int done = mosquitto_publish_v5(
        impl_->client, &number, message.topic.c_str(), static_cast<int>(message.payload.size()),
        message.payload.data(), qos, message.retained, properties.list());
    if (done == MOSQ_ERR_SUCCESS || (qos == 1 && done == MOSQ_ERR_NO_CONN)) {
      numbers.insert(number);
      return true;
    }
  }
  ++impl_->dropped;
  return false;
}

void Broker::subscribe(const std::string& filter, Delivery delivery) {
  (void)mosquitto_subscribe_v5(impl_->client, nullptr, filter.c_str(), qos_of(delivery),
                               MQTT_SUB_OPT_SEND_RETAIN_NEVER | MQTT_SUB_OPT_RETAIN_AS_PUBLISHED,
                               nullptr);
}

std::optional<BrokerNotice> Broker::next() {
  const std::lock_guard lock(impl_->mutex);
  eventfd_t ignored = 0;
  ::eventfd_read(impl_->readable, &ignored);
  if (impl_->notices.empty()) return std::nullopt;
  BrokerNotice oldest = std::move(impl_->notices.front());
  impl_->notices.pop_front();
  if (!impl_->notices.empty()) ::eventfd_write(impl_->readable, 1);
  return oldest;
}

int Broker::descriptor() const noexcept { return impl_->readable; }

std::uint64_t Broker::take_dropped() noexcept { return impl_->dropped.exchange(0); }

}  // namespace hedgehog::mqtt
