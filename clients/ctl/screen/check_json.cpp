// SPDX-License-Identifier: MIT
#include "clients/ctl/screen/check_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

namespace hedgehog::client {

namespace {

using nlohmann::ordered_json;

/// Removes the number at the beginning of `text` and returns it; null if there is none.
ordered_json take_number(std::string_view& text) {
  double number = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return nullptr;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return number;
}

/// Parses "61.2;60;70" and "412us;500".
ordered_json measure_of(std::string_view text) {
  ordered_json measure;
  measure["value"] = take_number(text);
  measure["unit"] = text.substr(0, text.find(';'));
  for (const char* threshold : {"warning", "critical"}) {
    text.remove_prefix(std::min(text.size(), text.find(';')));
    if (text.empty()) break;
    text.remove_prefix(1);
    measure[threshold] = take_number(text);
  }
  return measure;
}

}  // namespace

std::string check_json(const Check& check) {
  static constexpr std::array kStates{"OK", "WARNING", "CRITICAL", "UNKNOWN"};
  const std::string between = " - ";
  const std::size_t bar = check.line.rfind(" | ");
  const std::string_view sentence = std::string_view(check.line).substr(0, bar);
  const std::size_t begin = sentence.find(between);
  ordered_json object;
  object["code"] = check.code;
  object["state"] = kStates.at(static_cast<std::size_t>(check.code));
  object["message"] =
      begin == std::string_view::npos ? sentence : sentence.substr(begin + between.size());
  object["measures"] = ordered_json::object();
  if (bar != std::string::npos) {
    std::istringstream measures(check.line.substr(bar + 3));
    for (std::string one; measures >> one;) {
      const std::size_t equals = one.find('=');
      if (equals != std::string::npos)
        object["measures"][one.substr(0, equals)] = measure_of(one.substr(equals + 1));
    }
  }
  return object.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace hedgehog::client
