// SPDX-License-Identifier: MIT
#include "clients/lib/client_error.h"

#include <algorithm>
#include <boost/throw_exception.hpp>
#include <stdexcept>

namespace hedgehog::client {

namespace {

// The longest wait until the next connection that a daemon can ask for.
constexpr std::chrono::milliseconds kMaxRetryAfter{60'000};

}  // namespace

bool may_connect_later(const ClientError& error) noexcept {
  if (error.failure == Failure::kBadAddress) return false;
  if (error.failure != Failure::kRefused) return true;
  if (!error.refusal) return false;
  return error.refusal->code == protocol::ErrorCode::kBusy ||
         (error.refusal->code == protocol::ErrorCode::kUnauthorized &&
          error.refusal->retry_after_ms);
}

std::chrono::milliseconds retry_after(const ClientError& error) noexcept {
  if (!error.refusal || !error.refusal->retry_after_ms) return std::chrono::milliseconds(0);
  return std::min(kMaxRetryAfter, std::chrono::milliseconds(*error.refusal->retry_after_ms));
}

std::string reason_of(const boost::system::error_code& error) {
  std::string text = error.message();
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] += 'a' - 'A';
  return text;
}

void throw_exception_from_error(const ClientError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.message), where);
}

}  // namespace hedgehog::client
