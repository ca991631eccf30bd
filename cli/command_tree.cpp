// SPDX-License-Identifier: MIT
#include "cli/command_tree.h"

#include <CLI/CLI.hpp>
#include <string_view>

namespace hedgehog::cli {

namespace {

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Choices in "device|world|coil", and in CLI11's format "TEXT:{client,daemon}".
std::vector<std::string> choices_of(std::string_view type) {
  const std::size_t open = type.find('{');
  if (open != std::string_view::npos && type.ends_with('}'))
    return split(type.substr(open + 1, type.size() - open - 2), ',');
  return type.find('|') != std::string_view::npos ? split(type, '|') : std::vector<std::string>{};
}

/// Removes the validators that CLI11 appends to the type: "TEXT:DIR".
std::string without_checks(const std::string& type) {
  for (const char* plain : {"TEXT", "INT", "UINT", "FLOAT"})
    if (type.starts_with(std::string(plain) + ":")) return plain;
  return type.empty() ? "VALUE" : type;
}

CommandOption option_of(const CLI::Option& option) {
  CommandOption out;
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) {
    const std::string type = option.get_type_name();
    out.choices = choices_of(type);
    out.value = without_checks(type);
    if (out.choices.size() > 1) {
      out.value.clear();
      for (const std::string& choice : out.choices)
        out.value += (out.value.empty() ? "" : "|") + choice;
    }
  }
  out.help = option.get_description();
  out.environment = option.get_envname();
  out.fallback = option.get_default_str();
  out.required = option.get_required();
  return out;
}

}  // namespace

Command command_tree(const CLI::App& app) {
  Command command;
  command.name = app.get_name();
  command.help = app.get_description();
  command.footer = app.get_footer();
  command.options_behind_verbs = app.get_fallthrough();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    CommandOption one = option_of(*option);
    if (option->get_positional()) {
      CommandOption argument = one;
      argument.names = {option->get_name(true)};
      command.arguments.push_back(std::move(argument));
    }
    if (!one.names.empty()) command.options.push_back(std::move(one));
  }
  const auto visible = [](const CLI::App* verb) { return !verb->get_group().empty(); };
  for (const CLI::App* verb : app.get_subcommands(visible))
    command.verbs.push_back(command_tree(*verb));
  command.needs_verb = app.get_require_subcommand_min() > 0;
  return command;
}

}  // namespace hedgehog::cli
