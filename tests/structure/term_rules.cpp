// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

/// A word that no name may contain, from CONTRIBUTING.md, *Terms*, and its replacements.
struct Term {
  std::string_view word;
  std::string_view instead;
};
constexpr std::array kTerms{
    Term{"absurd", "implausible, non_finite"},
    Term{"anybody", "client, user"},
    Term{"believe", "plausible, expected"},
    Term{"believed", "plausible, expected"},
    Term{"believes", "plausible, expected"},
    Term{"blows", "impacts"},
    Term{"complain", "report_error"},
    Term{"complaint", "error_message"},
    Term{"disown", "release"},
    Term{"door", "listener, endpoint"},
    Term{"doorkeeper", "origin_check"},
    Term{"doors", "listener, endpoint"},
    Term{"doubt", "arming_blocker, margin"},
    Term{"farewell", "shutdown, close"},
    Term{"foreigner", "foreign client"},
    Term{"foretell", "forecast"},
    Term{"foretold", "forecast"},
    Term{"forget", "clear, reset, discard"},
    Term{"glance", "measured"},
    Term{"goodbye", "shutdown, close"},
    Term{"greeting", "first_message"},
    Term{"happening", "event"},
    Term{"heard", "received"},
    Term{"heed", "handle"},
    Term{"judge", "check, classify"},
    Term{"lately", "mean"},
    Term{"learn", "update, identify"},
    Term{"least", "min"},
    Term{"lend", "hand to"},
    Term{"looker", "scanner"},
    Term{"machinery", "threads"},
    Term{"mend", "recover, correct"},
    Term{"newcomer", "new owner"},
    Term{"obey", "run, apply"},
    Term{"obeys", "is_active"},
    Term{"owed", "pending"},
    Term{"owes", "has_pending"},
    Term{"patience", "timeout, backoff"},
    Term{"room", "ambient, capacity"},
    Term{"rooms", "ambient, capacity"},
    Term{"rude", "malformed"},
    Term{"said", "given, requested, reported"},
    Term{"say", "print, publish, report"},
    Term{"shelf", "storage"},
    Term{"somebody", "client, user"},
    Term{"someone", "client, user"},
    Term{"stranger", "other"},
    Term{"suspicious", "pending"},
    Term{"tell", "print, publish, report"},
    Term{"tells", "print, publish, report"},
    Term{"told", "received, reported"},
    Term{"trouble", "problem, fault"},
    Term{"unheard", "unread"},
    Term{"unjudged", "unchecked"},
    Term{"unsaid", "pending, unreported"},
    Term{"untaken", "unread"},
    Term{"whoever", "client, owner"},
    Term{"wish", "request, spec"},
    Term{"witness", "source"},
};

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The next part of a name from `at` on: "kMaxTold_s" is k, max, told, s.
std::string next_part(std::string_view name, std::size_t& at) {
  const auto upper = [&](std::size_t i) {
    return i < name.size() && std::isupper(static_cast<unsigned char>(name[i])) != 0;
  };
  std::string part;
  while (at < name.size() && name[at] == '_') ++at;
  while (at < name.size() && name[at] != '_') {
    if (!part.empty() && upper(at) && !upper(at - 1)) break;
    part += static_cast<char>(std::tolower(static_cast<unsigned char>(name[at++])));
  }
  return part;
}

/// The line without strings and comments.
std::string code_of(std::string_view line) {
  std::string code;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line.substr(i, 2) == "//") break;
    if (line.substr(i, 2) == "R\"") {
      const std::size_t open = line.find('(', i);
      const std::string end = ")" + std::string(line.substr(i + 2, open - i - 2)) + "\"";
      const std::size_t close = line.find(end, i);
      if (open == line.npos || close == line.npos) break;
      i = close + end.size() - 1;
      continue;
    }
    if (line[i] != '"') {
      code += line[i];
      continue;
    }
    for (++i; i < line.size() && line[i] != '"'; ++i) i += line[i] == '\\' ? 1 : 0;
    code += ' ';
  }
  return code;
}

}  // namespace

Violations check_terms(const SourceFile& file) {
  Violations violations;
  if (!(file.path.ends_with(".h") || file.path.ends_with(".cpp"))) return violations;
  for (std::size_t n = 0; n < file.lines.size(); ++n) {
    if (file.lines[n].starts_with("#include")) continue;
    const std::string code = code_of(file.lines[n]);
    for (std::size_t i = 0; i < code.size();) {
      std::size_t end = i;
      while (end < code.size() && is_name(code[end])) ++end;
      const std::string_view name = std::string_view(code).substr(i, end - i);
      for (std::size_t at = 0; at < name.size();) {
        const std::string part = next_part(name, at);
        const auto term = std::find_if(kTerms.begin(), kTerms.end(),
                                       [&](const Term& one) { return one.word == part; });
        if (term != kTerms.end()) {
          violations.push_back(file.path + ":" + std::to_string(n + 1) + ": " + std::string(name) +
                               ": not \"" + part + "\" but " + std::string(term->instead));
        }
      }
      i = end + 1;
    }
  }
  return violations;
}

}  // namespace hedgehog::structure
