// SPDX-License-Identifier: MIT
#include "core/session.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

namespace hedgehog::unreal {

namespace {

constexpr std::int64_t kHelloId = 1;
constexpr const char* kNobody = "no daemon answers there";
constexpr const char* kNoDaemon = "the server is not a Hedgehog daemon";

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", value);
  return text;
}

}  // namespace

Answer refusal_of(const Json& error) {
  Answer refused;
  refused.failure = Failure::kRefused;
  refused.code = static_cast<int>(error["code"].number());
  refused.message = error["message"].text();
  refused.data = error["data"];
  refused.name = refused.data["name"].text();
  return refused;
}

Answer failed(Failure failure, std::string message, double retry_after_s) {
  Answer answer;
  answer.failure = failure;
  answer.message = std::move(message);
  answer.retry_after_s = retry_after_s;
  return answer;
}

Session::Session(std::unique_ptr<Transport> transport, Json introduction, double timeout_s,
                 double now_s, OnNotification on_notification)
    : transport_(std::move(transport)),
      introduction_(std::move(introduction)),
      timeout_s_(timeout_s),
      deadline_s_(now_s + timeout_s),
      on_notification_(std::move(on_notification)) {}

void Session::poll(double now_s) {
  if (!ended_.empty()) return;
  const Transport::State state = transport_->state();
  if (state == Transport::State::kOpen && !open_) {
    open_ = true;
    deadline_s_ = now_s + timeout_s_;
    last_id_ = kHelloId;
    send("hello", introduction_, kHelloId);
  }
  flush();
  if (open_) read();
  if (ended_.empty() && state == Transport::State::kEnded) ended_ = kNobody;
  if (ended_.empty()) check_deadlines(now_s);
}

void Session::ask(const std::string& method, const Json& params, OnAnswer on_answer, double now_s) {
  ++last_id_;
  pending_.push_back({last_id_, method, std::move(on_answer), now_s + timeout_s_});
  send(method, params, last_id_);
}

void Session::notify(const std::string& method, const Json& params) { send(method, params, 0); }

double Session::retry_after_s() const {
  const double wait_s = notice_["data"]["retry_after_ms"].number() / 1000.0;
  return std::clamp(wait_s, 0.0, kMaxRetryAfterS);
}

std::vector<OnAnswer> Session::close(std::string reason) {
  ended_ = std::move(reason);
  transport_.reset();
  std::vector<OnAnswer> unanswered;
  for (Pending& one : pending_) unanswered.push_back(std::move(one.on_answer));
  pending_.clear();
  return unanswered;
}

void Session::send(const std::string& method, const Json& params, std::int64_t id) {
  Json message = Json::object({{"jsonrpc", "2.0"}});
  if (id > 0) message.set("id", id);
  message.set("method", method);
  if (!params.fields().empty()) message.set("params", params);
  unsent_ += message.to_text();
  unsent_ += '\n';
  flush();
}

void Session::flush() {
  if (!open_ || unsent_.empty() || !ended_.empty()) return;
  bool ended = false;
  unsent_.erase(0, transport_->send(unsent_, ended));
  if (ended) {
    // Data received before that is read first.
    writable_ = false;
    unsent_.clear();
  } else if (unsent_.size() > kMaxUnsent) {
    ended_ = "the daemon does not read from the connection";
  }
}

void Session::read() {
  char bytes[4096];
  bool ended = false;
  while (ended_.empty()) {
    const std::size_t count = transport_->receive(bytes, sizeof bytes, ended);
    if (count == 0) break;
    reached_ = true;
    take({bytes, count});
  }
  if (!ended_.empty()) return;
  if ((ended || !writable_) && !notice_["message"].text().empty())
    ended_ = notice_["message"].text();
  else if (ended)
    ended_ = reached_ ? "the daemon closed it" : kNobody;
  else if (!writable_)
    ended_ = "it cannot be written to";
}

void Session::take(std::string_view bytes) {
  for (std::size_t end = bytes.find('\n'); end != std::string_view::npos && ended_.empty();
       end = bytes.find('\n')) {
    received_.append(bytes.substr(0, end));
    bytes.remove_prefix(end + 1);
    const std::string line = std::exchange(received_, {});
    // A callback may close this session.
    if (line.find_first_not_of(" \t\r") != std::string::npos) take_line(line);
  }
  received_.append(bytes);
  if (received_.size() > kMaxLine && ended_.empty()) ended_ = "a line of more than 4 MiB";
}

void Session::take_line(const std::string& line) {
  const std::optional<Json> message = Json::parse(line);
  if (!message || !message->is(Json::Kind::kObject)) {
    ended_ = kNoDaemon;
    return;
  }
  const bool answers = !(*message)["id"].is(Json::Kind::kNull);
  notice_ = answers ? Json() : (*message)["error"];
  if ((*message)["method"].is(Json::Kind::kString)) {
    const Json& params = (*message)["params"];
    on_notification_((*message)["method"].text(), params);
    return;
  }
  const auto id = static_cast<std::int64_t>((*message)["id"].number());
  if (id == kHelloId) {
    take_introduction(*message);
    return;
  }
  const auto asked = std::find_if(pending_.begin(), pending_.end(),
                                  [id](const Pending& one) { return one.id == id; });
  if (asked == pending_.end()) return;
  const OnAnswer on_answer = std::move(asked->on_answer);
  pending_.erase(asked);
  Answer answer;
  if ((*message)["error"].is(Json::Kind::kObject))
    answer = refusal_of((*message)["error"]);
  else
    answer.result = (*message)["result"];
  on_answer(answer);
}

void Session::take_introduction(const Json& message) {
  if (message["error"].is(Json::Kind::kObject)) {
    refusal_ = message["error"];
    ended_ = refusal_["message"].text();
  } else if (message["result"]["limits"].is(Json::Kind::kObject)) {
    hello_ = message["result"];
  } else {
    ended_ = kNoDaemon;
  }
}

void Session::check_deadlines(double now_s) {
  const std::string late = ": no response within " + seconds(timeout_s_);
  if (hello_.is(Json::Kind::kNull) && now_s > deadline_s_)
    ended_ = open_ ? "hello" + late : std::string(kNobody);
  for (const Pending& one : pending_)
    if (now_s > one.deadline_s) ended_ = one.method + late;
}

}  // namespace hedgehog::unreal
