// SPDX-License-Identifier: MIT
#include "tests/soak/pending_responses.h"

#include <algorithm>
#include <utility>

#include "tests/soak/failure.h"
#include "tests/soak/json_text.h"

namespace hedgehog::soak {
namespace {

/// Why `message` is not the response to a request of `method` that may only fail with `error`.
std::string mismatch(const protocol::Json& message, const std::optional<protocol::Method>& method,
                     const std::optional<int>& error, CompletedRequest& completed) {
  const protocol::Json* version = message.find("jsonrpc");
  if (version == nullptr || protocol::to_text(*version) != R"("2.0")") return "no version";
  const protocol::Json* result = message.find("result");
  const protocol::Json* failed = message.find("error");
  if ((result == nullptr) == (failed == nullptr)) return "not one of result and error";
  completed.result = result;
  if (result != nullptr) {
    if (error || !method) return "a result, though the request is wrong";
    return protocol::violation(message_definitions(), protocol::result_name(*method), *result);
  }
  if (std::string broken = protocol::violation(message_definitions(), "Error", *failed);
      !broken.empty())
    return broken;
  const protocol::Json* code = failed->find("code");
  const auto* number = code == nullptr ? nullptr : code->as<std::int64_t>();
  if (number == nullptr) return "an error without a code";
  completed.error = static_cast<int>(*number);
  if (error) return completed.error == *error ? "" : "another error than " + std::to_string(*error);
  const auto which = static_cast<protocol::ErrorCode>(completed.error);
  return protocol::possible_errors(protocol::info(*method)).contains(which)
             ? ""
             : "an error that the method does not list";
}

}  // namespace

void PendingResponses::expect(const protocol::Incoming& incoming) {
  Batch expected;
  for (const protocol::Item& item : incoming.items) {
    if (!item.id) continue;
    std::optional<int> error;
    if (item.request.has_error()) error = static_cast<int>(item.request.error().code);
    expected.push_back({item.id->json, item.method, error});
  }
  if (expected.empty()) return;
  ++size_;
  if (incoming.batch)
    batches_.push_back(std::move(expected));
  else
    single_[expected.front().id].push_back(expected.front());
}

void PendingResponses::expect_parse_error() {
  ++size_;
  single_["null"].push_back(
      {"null", std::nullopt, static_cast<int>(protocol::ErrorCode::kParseError)});
}

void PendingResponses::receive(const protocol::Json& message, const OnResponse& on_response) {
  if (const auto* many = message.as<protocol::Json::List>())
    receive_batch(*many, on_response);
  else
    receive_one(message, on_response);
  --size_;
}

void PendingResponses::receive_one(const protocol::Json& message, const OnResponse& on_response) {
  const protocol::Json* id = message.find("id");
  const auto found = single_.find(id == nullptr ? "" : protocol::to_text(*id));
  if (found == single_.end())
    throw Failure("a response that nobody asked for: " + shortened(message));
  std::string why_not;
  // Requests of the same id (mostly null) are answered in any order.
  for (auto one = found->second.begin(); one != found->second.end(); ++one) {
    CompletedRequest completed{one->id, one->method};
    const std::string wrong = mismatch(message, one->method, one->error, completed);
    if (!wrong.empty()) {
      why_not = wrong;
      continue;
    }
    found->second.erase(one);
    if (found->second.empty()) single_.erase(found);
    on_response(completed);
    return;
  }
  throw Failure("a wrong response (" + why_not + "): " + shortened(message));
}

void PendingResponses::receive_batch(const protocol::Json::List& messages,
                                     const OnResponse& on_response) {
  std::vector<std::string> ids;
  for (const protocol::Json& one : messages) {
    const protocol::Json* id = one.find("id");
    ids.push_back(id == nullptr ? "" : protocol::to_text(*id));
  }
  const auto batch = std::find_if(batches_.begin(), batches_.end(), [&](const Batch& expected) {
    return std::equal(expected.begin(), expected.end(), ids.begin(), ids.end(),
                      [](const Expected& one, const std::string& id) { return one.id == id; });
  });
  if (batch == batches_.end())
    throw Failure("responses of no batch that was sent, or in another order: " +
                  shortened(protocol::Json{messages}));
  for (std::size_t i = 0; i < messages.size(); ++i) {
    CompletedRequest completed{ids[i], (*batch)[i].method};
    const std::string wrong =
        mismatch(messages[i], (*batch)[i].method, (*batch)[i].error, completed);
    if (!wrong.empty())
      throw Failure("a wrong response in a batch (" + wrong + "): " + shortened(messages[i]));
    on_response(completed);
  }
  batches_.erase(batch);
}

std::string PendingResponses::text() const {
  std::string text =
      std::to_string(single_.size()) + " ids, " + std::to_string(batches_.size()) + " batches;";
  for (const auto& [id, requests] : single_) {
    const auto& method = requests.front().method;
    text += " " + id + " " + (method ? std::string(protocol::name(*method)) : "no request") + ",";
    constexpr std::size_t kEnough = 400;
    if (text.size() > kEnough) break;
  }
  return text;
}

}  // namespace hedgehog::soak
