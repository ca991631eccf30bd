// SPDX-License-Identifier: MIT
#include "cli/error_message.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "base/spelling.h"

namespace hedgehog::cli {

namespace {

/// The app, the given verb, and its nested verbs.
std::vector<const CLI::App*> given_verbs(const CLI::App& app) {
  std::vector<const CLI::App*> given{&app};
  while (true) {
    const auto verbs = given.back()->get_subcommands();
    if (verbs.empty()) return given;
    given.push_back(verbs.back());
  }
}

bool is_option(std::string_view word) { return word.size() > 1 && word.starts_with('-'); }

/// The first unparsed word; preferably an unknown option, not its value.
std::string extra_word(const CLI::App& app) {
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::find_if(words.begin(), words.end(), is_option);
  return option != words.end() ? *option : words.empty() ? std::string() : words.front();
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string_view meant = base::nearest(word, views);
  return meant.empty() ? "" : "; did you mean '" + std::string(meant) + "'?";
}

std::string no_option(const std::vector<const CLI::App*>& given, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* app : given) {
    for (const CLI::Option* option : app->get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  // The value may follow an equals sign.
  return "unknown option '" + word + "'" + did_you_mean(word.substr(0, word.find('=')), names);
}

std::vector<const CLI::App*> known_verbs(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::string no_verb(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* verb : known_verbs(app)) names.push_back(verb->get_name());
  return "there is no verb '" + word + "'" + did_you_mean(word, names);
}

}  // namespace

std::string error_message(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<const CLI::App*> given = given_verbs(app);
  const std::string word = extra_word(app);
  const bool lacks_verb = given.back()->get_require_subcommand_min() > 0;
  if (is_option(word)) return no_option(given, word);
  if (!word.empty() && !known_verbs(*given.back()).empty()) return no_verb(*given.back(), word);
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
    return "unexpected argument '" + word + "'";
  return lacks_verb && error.get_name() == "RequiredError" ? "a verb is missing" : error.what();
}

std::string usage_error(const CLI::App& app, const std::string& what) {
  std::string name;
  for (const CLI::App* verb : given_verbs(app))
    name += (name.empty() ? "" : " ") + verb->get_name();
  return name + ": " + what + "; see " + name + " --help";
}

}  // namespace hedgehog::cli
