// SPDX-License-Identifier: MIT
#include "clients/lib/connection.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "clients/lib/discovery/ball_search.h"

namespace hedgehog::client {
namespace {

using protocol::Id;

/// The daemon refuses longer lines (protocol/README.md).
constexpr std::size_t kMaxOutgoingLine = 65'536;

/// "no daemon answers at A, B or C"; the reason is added unless there is no listener.
std::string no_daemon_at(const std::vector<std::string>& places) {
  std::string text = "no daemon answers at ";
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0) text += i + 1 == places.size() ? " or " : ", ";
    text += places[i];
  }
  return text;
}

bool no_listener(const std::string& reason) {
  return reason == "connection refused" || reason == "no such file or directory";
}

Outcome<void> send(LineSocket& socket, const std::string& line, Clock::time_point deadline) {
  if (line.size() > kMaxOutgoingLine) {
    return ClientError{
        Failure::kProtocol,
        "the request is longer than 64 KiB: " + std::to_string(line.size()) + " bytes",
        {}};
  }
  return socket.write(line, deadline);
}

}  // namespace

Connection::Connection(LineSocket socket, Address address)
    : socket_(std::move(socket)), address_(std::move(address)) {}

Outcome<Connection> Connection::open(const std::vector<Address>& addresses, Milliseconds timeout) {
  const auto located = locate(addresses);
  if (!located) return located.error();
  const auto deadline = Clock::now() + timeout;
  std::vector<std::string> places;
  for (const Address& address : *located) {
    auto socket = LineSocket::connect(address, deadline);
    if (socket) return after_hello(Connection(*std::move(socket), address), deadline);
    const std::string& why = socket.error().message;
    places.push_back(to_string(address) + (no_listener(why) ? "" : " (" + why + ")"));
  }
  return ClientError{Failure::kNoDaemon, no_daemon_at(places), {}};
}

Outcome<Connection> Connection::after_hello(Connection connection, Clock::time_point deadline) {
  const auto& token = connection.address_.token;
  if (!token) return connection;
  const auto left = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
  const auto hello = connection.hello({}, token, std::max(left, Milliseconds(1)));
  if (!hello) return hello.error();
  return connection;
}

Outcome<Connection> Connection::start(const Address& address) {
  auto socket = LineSocket::start_connect(address);
  if (!socket) return socket.error();
  return Connection(*std::move(socket), address);
}

Outcome<Connection> Connection::reopen(const std::vector<Address>& addresses,
                                       Milliseconds timeout) {
  const auto deadline = Clock::now() + timeout;
  Backoff backoff;
  for (;;) {
    const auto left = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
    auto connection = open(addresses, std::clamp(left, Milliseconds(0), kConnectTimeout));
    if (connection || !may_connect_later(connection.error())) return connection;
    const auto pause = std::max(backoff.next(), retry_after(connection.error()));
    if (Clock::now() + pause >= deadline) return connection;
    std::this_thread::sleep_for(pause);
  }
}

Outcome<std::string> Connection::call_text(const protocol::Request& request, Milliseconds timeout) {
  const Id id = Id::number(++last_id_);
  return exchange(id, protocol::encode_request(id, request), timeout);
}

Outcome<std::string> Connection::call_raw(std::string_view method, std::string_view params_json,
                                          Milliseconds timeout) {
  const Id id = Id::number(++last_id_);
  return exchange(id, protocol::encode_raw_request(id, method, params_json), timeout);
}

Outcome<void> Connection::notify(const protocol::Request& request, Milliseconds timeout) {
  return send(socket_, protocol::encode_request(std::nullopt, request), Clock::now() + timeout);
}

Outcome<void> Connection::notify_raw(std::string_view method, std::string_view params_json,
                                     Milliseconds timeout) {
  return send(socket_, protocol::encode_raw_request(std::nullopt, method, params_json),
              Clock::now() + timeout);
}

Outcome<Id> Connection::request(const protocol::Request& request, Milliseconds timeout) {
  const Id id = Id::number(++last_id_);
  return send_request(id, protocol::encode_request(id, request), timeout);
}

Outcome<Id> Connection::request_raw(std::string_view method, std::string_view params_json,
                                    Milliseconds timeout) {
  const Id id = Id::number(++last_id_);
  return send_request(id, protocol::encode_raw_request(id, method, params_json), timeout);
}

Outcome<Id> Connection::send_request(const Id& id, const std::string& line, Milliseconds timeout) {
  if (auto sent = send(socket_, line, Clock::now() + timeout); !sent) return sent.error();
  pending_.push_back(id);
  return id;
}

std::optional<protocol::Reply> Connection::response() {
  if (responses_.empty()) return std::nullopt;
  std::optional<protocol::Reply> oldest = std::move(responses_.front());
  responses_.pop_front();
  return oldest;
}

Outcome<protocol::HelloResult> Connection::hello(std::string client,
                                                 std::optional<std::string> token,
                                                 Milliseconds timeout) {
  return call(protocol::Hello{std::move(client), "1.0", std::move(token)}, timeout);
}

Outcome<std::string> Connection::exchange(const Id& id, const std::string& line,
                                          Milliseconds timeout) {
  const auto deadline = Clock::now() + timeout;
  if (auto sent = send(socket_, line, deadline); !sent) return sent.error();
  for (;;) {
    auto response = socket_.read(deadline);
    if (!response) return response.error();
    if (!*response) {
      return ClientError{
          Failure::kTimeout,
          "the daemon has not answered within " + std::to_string(timeout.count()) + " ms",
          {}};
    }
    auto reply = handle_line(**response, id);
    if (!reply) return reply.error();
    if (!*reply) continue;
    auto& result = (*reply)->result;
    if (result) return *std::move(result);
    return ClientError{Failure::kRefused, result.error().message, result.error()};
  }
}

Outcome<std::optional<protocol::Reply>> Connection::handle_line(const std::string& line,
                                                                const Id& id) {
  auto messages = protocol::decode_messages(line);
  if (!messages) return ClientError{Failure::kProtocol, messages.error().message, {}};
  std::optional<protocol::Reply> own;
  for (auto& message : *messages) {
    if (auto* reply = std::get_if<protocol::Reply>(&message)) {
      // An error without an id concerns the connection: too many connections, an invalid line.
      const bool about_all = reply->id == Id{} && !reply->result;
      const auto pending = std::find(pending_.begin(), pending_.end(), reply->id);
      if (pending != pending_.end()) {
        pending_.erase(pending);
        responses_.push_back(std::move(*reply));
      } else if (reply->id == id || about_all) {
        own = std::move(*reply);
      }
    } else if (auto* event = std::get_if<protocol::EventMessage>(&message)) {
      queue(std::move(*event));
    } else if (auto* telemetry = std::get_if<protocol::TelemetryMessage>(&message)) {
      queue(std::move(*telemetry));
    }
  }
  return own;
}

void Connection::queue(Notification notification) {
  const auto is_telemetry = [](const Notification& one) {
    return std::holds_alternative<protocol::TelemetryMessage>(one);
  };
  if (is_telemetry(notification) && ++unread_telemetry_ > kMaxTelemetry) {
    unread_.erase(std::find_if(unread_.begin(), unread_.end(), is_telemetry));
    --unread_telemetry_;
  }
  unread_.push_back(std::move(notification));
}

Outcome<bool> Connection::receive(Milliseconds timeout) {
  auto line = socket_.read(Clock::now() + timeout);
  if (!line) return line.error();
  if (!*line) return false;
  auto reply = handle_line(**line, Id::number(0));
  if (!reply) return reply.error();
  if (!*reply) return true;
  const auto& refusal = (*reply)->result.error();
  return ClientError{Failure::kRefused, refusal.message, refusal};
}

std::optional<Notification> Connection::notification() {
  if (unread_.empty()) return std::nullopt;
  std::optional<Notification> oldest = std::move(unread_.front());
  unread_.pop_front();
  if (std::holds_alternative<protocol::TelemetryMessage>(*oldest)) --unread_telemetry_;
  return oldest;
}

Outcome<std::optional<Notification>> Connection::next(Milliseconds timeout) {
  const auto deadline = Clock::now() + timeout;
  while (unread_.empty()) {
    const auto left = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
    const auto received = receive(std::max(left, Milliseconds(0)));
    if (!received) return received.error();
    if (!*received) return std::optional<Notification>();
  }
  return notification();
}

}  // namespace hedgehog::client
