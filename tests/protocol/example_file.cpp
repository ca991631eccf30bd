// SPDX-License-Identifier: MIT
#include "tests/protocol/example_file.h"

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "tests/protocol/child_path.h"

namespace hedgehog::protocol {
namespace {

constexpr std::string_view kAnything = "…";
constexpr std::size_t kNesting = 64;

bool is_anything(const Json& json) {
  const auto* text = json.as<std::string>();
  return text != nullptr && *text == kAnything;
}

std::optional<double> number_of(const Json& json) {
  if (const auto* integer = json.as<std::int64_t>()) return static_cast<double>(*integer);
  if (const auto* number = json.as<double>()) return *number;
  return std::nullopt;
}

std::string compare(const Json& expected, const Json& actual, const std::string& path);

std::string compare_objects(const Json& expected, const Json& actual, const std::string& path) {
  const bool open = expected.find(kAnything) != nullptr;
  for (const auto& [name, value] : *expected.as<Json::Object>()) {
    if (name == kAnything) continue;
    const std::string at = child_path(path, name);
    const Json* other = actual.find(name);
    if (other == nullptr) return at + " is missing";
    if (std::string different = compare(value, *other, at); !different.empty()) return different;
  }
  for (const auto& [name, value] : *actual.as<Json::Object>())
    if (!open && expected.find(name) == nullptr) return child_path(path, name) + " is not expected";
  return {};
}

std::string compare_lists(const Json::List& expected, const Json::List& actual,
                          const std::string& path) {
  // A wildcard after other items matches all further items; a list of wildcards fixes their number.
  const bool open = expected.size() > 1 && is_anything(expected.back()) &&
                    !is_anything(expected[expected.size() - 2]);
  const std::size_t fixed = expected.size() - (open ? 1 : 0);
  if (actual.size() < fixed || (!open && actual.size() != fixed))
    return path + " has " + std::to_string(actual.size()) + " items";
  for (std::size_t i = 0; i < fixed; ++i) {
    const std::string at = path + "[" + std::to_string(i) + "]";
    if (std::string different = compare(expected[i], actual[i], at); !different.empty())
      return different;
  }
  return {};
}

std::string compare(const Json& expected, const Json& actual, const std::string& path) {
  if (is_anything(expected)) return {};
  std::string differs = path + " is " + to_text(actual) + ", not " + to_text(expected);
  const auto wanted = number_of(expected);
  const auto got = number_of(actual);
  if (wanted && got) {
    constexpr double kEqual = 1e-9;
    return std::fabs(*wanted - *got) <= kEqual ? std::string() : differs;
  }
  if (expected.value.index() != actual.value.index()) return differs;
  if (expected.as<Json::Object>() != nullptr) return compare_objects(expected, actual, path);
  if (const auto* list = expected.as<Json::List>())
    return compare_lists(*list, *actual.as<Json::List>(), path);
  return to_text(expected) == to_text(actual) ? std::string() : differs;
}

}  // namespace

std::vector<Example> read_examples(std::string_view markdown) {
  std::vector<Example> examples;
  std::istringstream in{std::string(markdown)};
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with("```")) {
      inside = !inside && line == "```hedgehog";
      if (inside) examples.emplace_back();
      continue;
    }
    constexpr std::string_view kSent = "→ ";
    constexpr std::string_view kReceived = "← ";
    const bool sent = line.starts_with(kSent);
    if (inside && (sent || line.starts_with(kReceived)))
      examples.back().lines.push_back({sent, line.substr(kSent.size()), number});
  }
  return examples;
}

std::vector<Example> protocol_examples(const std::string& source_dir) {
  std::ifstream in(source_dir + "/protocol/README.md");
  std::stringstream text;
  text << in.rdbuf();
  return read_examples(text.str());
}

std::string mismatch(const Json& expected, const Json& actual) {
  return compare(expected, actual, "");
}

std::string mismatch(std::string_view expected, std::string_view actual) {
  const auto wanted = parse_json(expected, kNesting);
  const auto got = parse_json(actual, kNesting);
  if (!wanted || !got) return !wanted ? "what is expected is not JSON" : "what came is not JSON";
  return mismatch(*wanted, *got);
}

}  // namespace hedgehog::protocol
