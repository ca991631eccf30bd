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

Outcome<Connection> Connection::open(const std::vector<Address>& addresses, Milliseconds patience) {
  const auto located = locate(addresses);
  if (!located) return located.error();
  const auto deadline = Clock::now() + patience;
  std::vector<std::string> places;
  for (const Address& address : *located) {
    auto socket = LineSocket::connect(address, deadline);
    if (socket) return introduced(Connection(*std::move(socket), address), deadline);
    const std::string& why = socket.error().message;
    places.push_back(to_string(address) + (no_listener(why) ? "" : " (" + why + ")"));
  }
  return ClientError{Failure::kNoDaemon, no_daemon_at(places), {}};
}

Outcome<Connection> Connection::introduced(Connection connection, Clock::time_point deadline) {
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
                                       Milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  Backoff backoff;
  for (;;) {
    const auto left = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
    auto connection = open(addresses, std::clamp(left, Milliseconds(0), kConnectTimeout));
    if (connection) return connection;
    const auto pause = backoff.next();
    if (Clock::now() + pause >= deadline) return connection;
    std::this_thread::sleep_for(pause);
  }
}

Outcome<std::string> Connection::call_text(const protocol::Request& request,
                                           Milliseconds patience) {
  const Id id = Id::number(++last_id_);
  return exchange(id, protocol::encode_request(id, request), patience);
}

Outcome<std::string> Connection::call_raw(std::string_view method, std::string_view params_json,
                                          Milliseconds patience) {
  const Id id = Id::number(++last_id_);
  return exchange(id, protocol::encode_raw_request(id, method, params_json), patience);
}

Outcome<void> Connection::notify(const protocol::Request& request, Milliseconds patience) {
  return send(socket_, protocol::encode_request(std::nullopt, request), Clock::now() + patience);
}

Outcome<void> Connection::notify_raw(std::string_view method, std::string_view params_json,
                                     Milliseconds patience) {
  return send(socket_, protocol::encode_raw_request(std::nullopt, method, params_json),
              Clock::now() + patience);
}

Outcome<Id> Connection::ask(const protocol::Request& request, Milliseconds patience) {
  const Id id = Id::number(++last_id_);
  return send_asked(id, protocol::encode_request(id, request), patience);
}

Outcome<Id> Connection::ask_raw(std::string_view method, std::string_view params_json,
                                Milliseconds patience) {
  const Id id = Id::number(++last_id_);
  return send_asked(id, protocol::encode_raw_request(id, method, params_json), patience);
}

Outcome<Id> Connection::send_asked(const Id& id, const std::string& line, Milliseconds patience) {
  if (auto sent = send(socket_, line, Clock::now() + patience); !sent) return sent.error();
  asked_.push_back(id);
  return id;
}

std::optional<protocol::Reply> Connection::answer() {
  if (answers_.empty()) return std::nullopt;
  std::optional<protocol::Reply> oldest = std::move(answers_.front());
  answers_.pop_front();
  return oldest;
}

Outcome<protocol::HelloResult> Connection::hello(std::string client,
                                                 std::optional<std::string> token,
                                                 Milliseconds patience) {
  return call(protocol::Hello{std::move(client), "1.0", std::move(token)}, patience);
}

Outcome<std::string> Connection::exchange(const Id& id, const std::string& line,
                                          Milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  if (auto sent = send(socket_, line, deadline); !sent) return sent.error();
  for (;;) {
    auto answer = socket_.read(deadline);
    if (!answer) return answer.error();
    if (!*answer) {
      return ClientError{
          Failure::kTimeout,
          "the daemon has not answered within " + std::to_string(patience.count()) + " ms",
          {}};
    }
    auto reply = take(**answer, id);
    if (!reply) return reply.error();
    if (!*reply) continue;
    auto& result = (*reply)->result;
    if (result) return *std::move(result);
    return ClientError{Failure::kRefused, result.error().message, result.error()};
  }
}

Outcome<std::optional<protocol::Reply>> Connection::take(const std::string& line, const Id& id) {
  auto messages = protocol::decode_messages(line);
  if (!messages) return ClientError{Failure::kProtocol, messages.error().message, {}};
  std::optional<protocol::Reply> ours;
  for (auto& message : *messages) {
    if (auto* reply = std::get_if<protocol::Reply>(&message)) {
      // An error without an id concerns the connection: too many connections, an invalid line.
      const bool about_all = reply->id == Id{} && !reply->result;
      const auto asked = std::find(asked_.begin(), asked_.end(), reply->id);
      if (asked != asked_.end()) {
        asked_.erase(asked);
        answers_.push_back(std::move(*reply));
      } else if (reply->id == id || about_all) {
        ours = std::move(*reply);
      }
    } else if (auto* event = std::get_if<protocol::EventMessage>(&message)) {
      queue(std::move(*event));
    } else if (auto* telemetry = std::get_if<protocol::TelemetryMessage>(&message)) {
      queue(std::move(*telemetry));
    }
  }
  return ours;
}

void Connection::queue(Notification notification) {
  const auto is_telemetry = [](const Notification& one) {
    return std::holds_alternative<protocol::TelemetryMessage>(one);
  };
  if (is_telemetry(notification) && ++telemetry_waiting_ > kMaxTelemetry) {
    waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), is_telemetry));
    --telemetry_waiting_;
  }
  waiting_.push_back(std::move(notification));
}

Outcome<bool> Connection::receive(Milliseconds patience) {
  auto line = socket_.read(Clock::now() + patience);
  if (!line) return line.error();
  if (!*line) return false;
  auto reply = take(**line, Id::number(0));
  if (!reply) return reply.error();
  if (!*reply) return true;
  const auto& refusal = (*reply)->result.error();
  return ClientError{Failure::kRefused, refusal.message, refusal};
}

std::optional<Notification> Connection::notification() {
  if (waiting_.empty()) return std::nullopt;
  std::optional<Notification> oldest = std::move(waiting_.front());
  waiting_.pop_front();
  if (std::holds_alternative<protocol::TelemetryMessage>(*oldest)) --telemetry_waiting_;
  return oldest;
}

Outcome<std::optional<Notification>> Connection::next(Milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  while (waiting_.empty()) {
    const auto left = std::chrono::ceil<Milliseconds>(deadline - Clock::now());
    const auto received = receive(std::max(left, Milliseconds(0)));
    if (!received) return received.error();
    if (!*received) return std::optional<Notification>();
  }
  return notification();
}

}  // namespace hedgehog::client
