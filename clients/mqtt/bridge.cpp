// SPDX-License-Identifier: MIT
#include "clients/mqtt/bridge.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace hedgehog::mqtt {

namespace {

using client::Outcome;
using Milliseconds = std::chrono::milliseconds;

constexpr Milliseconds kMaxWait{500};
constexpr const char* kOnline = "online";
constexpr const char* kOffline = "offline";

std::string id_of(const protocol::Description& ball) {
  if (ball.board.serial) return *ball.board.serial;
  std::array<char, 256> host{};
  (void)::gethostname(host.data(), host.size() - 1);
  return ball.name + "-" + host.data();
}

/// The exit code of a permanent error.
std::optional<int> final_code(const client::ClientError& error) {
  if (!error.refusal) return std::nullopt;
  switch (error.refusal->code) {
    case protocol::ErrorCode::kInvalidParams:
      return EX_USAGE;
    case protocol::ErrorCode::kUnauthorized:
    case protocol::ErrorCode::kForbidden:
      return EX_NOPERM;
    default:
      return std::nullopt;
  }
}

}  // namespace

Bridge::Bridge(const BridgeOptions& options, Report report)
    : options_(options),
      report_(std::move(report)),
      topics_(options.prefix, options.id.value_or("")) {}

Result<void> Bridge::run(const std::function<bool()>& stop) {
  while (!stop()) {
    wait();
    if (auto handled = handle_daemon(); !handled) return handled;
    handle_broker();
  }
  return {};
}

void Bridge::wait() const {
  const TimePoint now = client::Clock::now();
  const TimePoint until = std::min(now + kMaxWait, daemon_ ? status_due_ : next_attempt_);
  const auto left = std::max(Milliseconds(0), std::chrono::ceil<Milliseconds>(until - now));
  std::array<pollfd, 2> waiting{{{-1, POLLIN, 0}, {-1, POLLIN, 0}}};
  if (daemon_) waiting[0].fd = daemon_->descriptor();
  if (broker_) waiting[1].fd = broker_->descriptor();
  (void)::poll(waiting.data(), waiting.size(), static_cast<int>(left.count()));
}

Result<void> Bridge::handle_daemon() {
  Outcome<void> done{};
  if (daemon_) {
    done = exchange();
  } else if (client::Clock::now() >= next_attempt_) {
    done = connect();
    if (done && !broker_)
      if (auto opened = open_broker(); !opened) return opened;
    if (done && broker_connected_) announce();
  }
  if (done) return {};
  if (const auto code = final_code(done.error())) return Problem(*code, done.error().message);
  on_lost(done.error().message);
  return {};
}

Outcome<void> Bridge::connect() {
  auto opened = client::Connection::open(options_.addresses);
  if (!opened) return opened.error();
  if (auto introduced = introduce(*opened); !introduced) return introduced;
  protocol::EventsSubscribe events;
  events.scope = protocol::Scope::kAll;
  if (const auto subscribed = opened->call(events); !subscribed) return subscribed.error();
  if (options_.telemetry_hz > 0.0) {
    const protocol::TelemetrySubscribe telemetry{options_.telemetry_hz, options_.fields};
    if (const auto subscribed = opened->call(telemetry); !subscribed) return subscribed.error();
  }
  auto status = opened->call_text(protocol::DeviceStatus{});
  if (!status) return status.error();
  status_ = *std::move(status);
  status_due_ = client::Clock::now() +
                std::chrono::ceil<Milliseconds>(std::chrono::duration<double>(options_.status_s));
  daemon_.emplace(*std::move(opened));
  backoff_.reset();
  report_once("connected to " + client::to_string(daemon_->address()) + " as " + topics_.id());
  return {};
}

Outcome<void> Bridge::introduce(client::Connection& daemon) {
  const auto hello = daemon.hello("hedgehog-mqtt/" HEDGEHOG_VERSION, options_.token);
  if (!hello) return hello.error();
  auto described = daemon.call_text(protocol::DeviceDescribe{});
  if (!described) return described.error();
  const auto ball = protocol::decode_result<protocol::Description>(*described);
  if (!ball) return client::ClientError{client::Failure::kProtocol, ball.error().message, {}};
  description_ = *std::move(described);
  ball_ = {ball->name, ball->model, hello->version};
  const Topics topics(options_.prefix, options_.id.value_or(id_of(*ball)));
  if (topics.id() != topics_.id()) {
    broker_.reset();
    broker_connected_ = false;
  }
  topics_ = topics;
  return {};
}

Outcome<void> Bridge::exchange() {
  const TimePoint now = client::Clock::now();
  if (status_request_ && now > response_due_)
    return client::ClientError{client::Failure::kTimeout, "the daemon does not answer", {}};
  if (now >= status_due_)
    if (auto sent = request_status(); !sent) return sent;
  for (;;) {
    const auto notification = daemon_->next(Milliseconds(0));
    if (!notification) return notification.error();
    while (const auto reply = daemon_->response()) take(*reply);
    if (!*notification) return {};
    take(**notification);
  }
}

Outcome<void> Bridge::request_status() {
  status_due_ = client::Clock::now() +
                std::chrono::ceil<Milliseconds>(std::chrono::duration<double>(options_.status_s));
  if (status_request_) return {};
  const auto sent = daemon_->request(protocol::DeviceStatus{});
  if (!sent) return sent.error();
  status_request_ = *sent;
  response_due_ = client::Clock::now() + client::response_timeout();
  return {};
}

void Bridge::take(const client::Notification& notification) {
  if (const auto* message = std::get_if<protocol::TelemetryMessage>(&notification)) {
    publish(topics_.telemetry(), message->json, Delivery::kQos0);
    return;
  }
  const auto& message = std::get<protocol::EventMessage>(notification);
  publish(topics_.event(message.event.type), message.json, Delivery::kQos1);
  // Effect events are too frequent; other events change the retained part of the status.
  if (!message.event.effect) status_due_ = client::Clock::now();
}

void Bridge::take(const protocol::Reply& reply) {
  if (status_request_ != reply.id) {
    publish_all(pending_.take(topics_, reply));
    return;
  }
  status_request_.reset();
  if (!reply.result) return;
  status_ = *reply.result;
  retain(topics_.status(), status_);
}

void Bridge::on_lost(const std::string& why) {
  const bool was_connected = daemon_.has_value();
  daemon_.reset();
  status_request_.reset();
  next_attempt_ = client::Clock::now() + backoff_.next();
  report_once(why + (was_connected ? "; reconnecting" : "; waiting for it"));
  if (!was_connected) return;
  publish_all(pending_.take_all(topics_));
  retain(topics_.availability(), kOffline);
}

Result<void> Bridge::open_broker() {
  BrokerOptions options = options_.broker;
  options.client_id = "hedgehog-" + topics_.id();
  options.urgent_topic = topics_.emergency_stop();
  options.will.topic = topics_.availability();
  options.will.payload = kOffline;
  options.will.delivery = Delivery::kQos1;
  options.will.retained = true;
  options.properties = {{"device", topics_.id()}, {"model", ball_.model}};
  auto opened = Broker::open(options);
  if (!opened) return opened.error();
  broker_ = *std::move(opened);
  return {};
}

void Bridge::handle_broker() {
  if (!broker_) return;
  while (auto notice = broker_->next()) {
    if (const auto* message = std::get_if<Message>(&*notice)) {
      request(*message);
    } else if (const auto* lost = std::get_if<BrokerLost>(&*notice)) {
      broker_connected_ = false;
      report_once("no broker at " + options_.broker.host + ": " + lost->why + "; reconnecting");
    } else {
      broker_connected_ = true;
      const auto dropped = broker_->take_dropped();
      report_once("connected to the broker at " + options_.broker.host +
                  (dropped == 0 ? std::string()
                                : "; messages dropped meanwhile: " + std::to_string(dropped)));
      broker_->subscribe(topics_.effects(), Delivery::kQos0);
      broker_->subscribe(topics_.emergency_stop(), Delivery::kQos1);
      announce();
    }
  }
}

void Bridge::announce() {
  if (options_.home_assistant) publish_all(discovery(*options_.home_assistant, topics_, ball_));
  retain(topics_.description(), description_);
  retain(topics_.status(), status_);
  retain(topics_.availability(), daemon_ ? kOnline : kOffline);
}

void Bridge::request(const Message& message) {
  const auto forwarded = remote_request(topics_, message);
  protocol::Result<std::string> refusal =
      protocol::error(protocol::ErrorCode::kDeviceAbsent, "no connection to the daemon");
  if (!forwarded) {
    refusal = forwarded.error();
  } else if (pending_.full() && message.topic != topics_.emergency_stop()) {
    refusal = protocol::busy("too many requests wait for the daemon", 100);
  } else if (daemon_) {
    const auto sent = daemon_->request_raw(forwarded->method, forwarded->params_json);
    if (sent) {
      pending_.add(*sent, message);
      return;
    }
    refusal = protocol::error(protocol::ErrorCode::kInternalError, sent.error().message);
    on_lost(sent.error().message);
  }
  publish_all(response_to(topics_, message, refusal));
}

void Bridge::publish(std::string topic, std::string payload, Delivery delivery) {
  if (broker_)
    broker_->publish(
        {.topic = std::move(topic), .payload = std::move(payload), .delivery = delivery});
}

void Bridge::retain(std::string topic, std::string payload) {
  // `announce` publishes it once the broker is connected again.
  if (broker_connected_)
    broker_->publish({.topic = std::move(topic),
                      .payload = std::move(payload),
                      .delivery = Delivery::kQos1,
                      .retained = true});
}

void Bridge::publish_all(const std::vector<Message>& messages) {
  if (!broker_) return;
  for (const Message& message : messages) broker_->publish(message);
}

void Bridge::report_once(const std::string& message) {
  if (message == reported_) return;
  reported_ = message;
  report_(message);
}

}  // namespace hedgehog::mqtt
