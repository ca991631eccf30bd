// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/pattern_verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "clients/ctl/patterns/pattern_file.h"
#include "clients/ctl/terminal/words.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::client {

namespace {

constexpr std::size_t kNameColumns = 20;
constexpr std::size_t kTimeColumns = 9;
constexpr std::size_t kLineColumns = 78;

/// "30", "30.5".
std::string seconds(std::int64_t ms) {
  return fmt::format("{:g}", static_cast<double>(ms) / 1000.0);
}

/// Options besides its name with which `play` plays all of it; empty: none.
std::string more_to_play(const protocol::Pattern& pattern) {
  const std::int64_t takes_ms = pattern.keyframes.back().t_ms;
  return takes_ms > protocol::kMaxDurationMs ? "--loop --for " + seconds(takes_ms) : "";
}

int put(Session& session, const protocol::Pattern& pattern) {
  const auto response = session.connection.call_text(protocol::PatternPut{pattern});
  if (!response) return report_error(response.error());
  if (session.json) {
    std::puts(response->c_str());
    return kDone;
  }
  const std::string more = more_to_play(pattern);
  std::printf("%s is stored: hedgehogctl play %s%s\n", pattern.name.c_str(), pattern.name.c_str(),
              more.empty() ? "" : (" " + more).c_str());
  return kDone;
}

}  // namespace

int run_pattern_list(Session& session) {
  const auto response = session.connection.call_text(protocol::PatternList{});
  if (!response) return report_error(response.error());
  if (session.json) {
    std::puts(response->c_str());
    return kDone;
  }
  const auto list = protocol::decode_result<protocol::PatternsResult>(*response);
  if (!list) return report_error({Failure::kProtocol, list.error().message, {}});
  for (const protocol::PatternSummary& p : list->patterns) {
    const std::string head = "  " + left(p.name, kNameColumns) +
                             right(std::to_string(p.duration_ms) + " ms", kTimeColumns) + "  ";
    const std::string line = head + p.description;
    std::puts((session.style.cuts ? cut(line, kLineColumns) : line).c_str());
  }
  return kDone;
}

int run_pattern_get(Session& session, const std::string& name) {
  const auto response = session.connection.call(protocol::PatternGet{name});
  if (!response) return report_error(response.error());
  std::puts(pattern_text(response->pattern).c_str());
  return kDone;
}

int run_pattern_put(Session& session, const std::string& file) {
  const auto pattern = read_pattern(file);
  return pattern ? put(session, *pattern) : static_cast<int>(report_error(pattern.error()));
}

int run_pattern_remove(Session& session, const std::string& name) {
  const auto response = session.connection.call_text(protocol::PatternRemove{name});
  if (!response) return report_error(response.error());
  std::puts(session.json ? response->c_str() : (name + " is removed").c_str());
  return kDone;
}

int run_pattern_import(const CommonOptions& common, const ImportOptions& options) {
  auto imported = read_foreign_pattern(options.file);
  if (!imported) return report_error(imported.error());
  if (!options.name.empty()) imported->pattern.name = options.name;
  if (const std::string more = more_to_play(imported->pattern); !more.empty()) {
    imported->notes.push_back("it takes " + seconds(imported->pattern.keyframes.back().t_ms) +
                              " s, one effect " + seconds(protocol::kMaxDurationMs) +
                              " s at most: play it with " + more);
  }
  print_notes(options.file, imported->notes);
  if (!options.put) {
    std::puts(pattern_text(imported->pattern).c_str());
    return kDone;
  }
  auto session = open_session(common);
  return session ? put(*session, imported->pattern)
                 : static_cast<int>(report_error(session.error()));
}

}  // namespace hedgehog::client
