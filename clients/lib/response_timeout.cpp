// SPDX-License-Identifier: MIT
#include "clients/lib/response_timeout.h"

#include <charconv>

namespace hedgehog::client {

namespace {

constexpr int kDefaultMs = 2'000;
constexpr int kMinMs = 100;
constexpr int kMaxMs = 600'000;

}  // namespace

std::chrono::milliseconds response_timeout(const Environment& environment) {
  const std::string text = environment("HEDGEHOG_PATIENCE_MS").value_or("");
  const char* const end = text.data() + text.size();
  int ms = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, ms);
  const bool valid = error == std::errc{} && rest == end && ms >= kMinMs && ms <= kMaxMs;
  return std::chrono::milliseconds(valid ? ms : kDefaultMs);
}

std::chrono::milliseconds response_timeout() {
  static const std::chrono::milliseconds timeout = response_timeout(process_environment);
  return timeout;
}

}  // namespace hedgehog::client
