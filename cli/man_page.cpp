// SPDX-License-Identifier: MIT
#include "cli/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace hedgehog::cli {

namespace {

/// Removes and returns the first code point of `text`; invalid sequences byte by byte.
char32_t take_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  char32_t code = bytes == 1 ? first : first & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes && i < text.size(); ++i)
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  text.remove_prefix(std::min(bytes, text.size()));
  return code;
}

/// Escapes `text` for troff: no character is interpreted as a request or an escape.
std::string escaped(std::string_view text) {
  std::string out;
  bool line_begins = true;
  while (!text.empty()) {
    const char32_t c = take_character(text);
    if (line_begins && (c == U'.' || c == U'\'')) out += "\\&";
    line_begins = c == U'\n';
    if (c == U'\\')
      out += "\\e";
    else if (c == U'-')
      out += "\\-";
    else if (c == U'"')
      out += "\\(dq";
    else if (c == U'\'')
      out += "\\(aq";
    else if (c < 0x80)
      out += static_cast<char>(c);
    else
      out += fmt::format("\\[u{:04X}]", static_cast<std::uint32_t>(c));
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

/// Joins lines with single spaces: man fills paragraphs.
std::string paragraph(const std::string& text) {
  std::string words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words += (words.empty() ? "" : " ") + word;
  return escaped(words) + "\n";
}

/// "shows the state of the ball" of "hedgehogctl: shows the state of the ball. More": for whatis.
std::string summary(const Command& program) {
  std::string text = program.help.substr(0, program.help.find_first_of(".\n"));
  for (const std::string& before : {program.name + ": ", program.name + " "})
    if (text.starts_with(before)) text.erase(0, before.size());
  return text.substr(0, text.find(": "));
}

std::string arguments_of(const Command& command) {
  std::string text;
  for (const CommandOption& argument : command.arguments) {
    const std::string name = italic(argument.names.front());
    text += argument.required ? " " + name : " [" + name + "]";
  }
  return text;
}

std::string synopsis_of(const Command& command, const std::string& path) {
  std::string text = bold(path);
  if (!command.options.empty()) text += " [" + italic("option") + " ...]";
  text += arguments_of(command);
  if (!command.verbs.empty()) {
    const std::string verb = italic("verb") + " ...";
    text += command.needs_verb ? " " + verb : " [" + verb + "]";
  }
  return text + "\n";
}

std::string option_entry(const CommandOption& option, bool positional) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + (positional ? italic(name) : bold(name));
  if (!positional && !option.value.empty()) names += " " + italic(option.value);
  std::string text = option.help;
  if (!option.fallback.empty()) text += " (" + option.fallback + " when not given)";
  return ".TP\n" + names + "\n" + (text.empty() ? "\\&\n" : paragraph(text));
}

std::string entries_of(const Command& command) {
  std::string page;
  for (const CommandOption& argument : command.arguments) {
    const auto is_option_too = [&](const CommandOption& option) {
      return option.help == argument.help;
    };
    if (!argument.help.empty() &&
        std::none_of(command.options.begin(), command.options.end(), is_option_too))
      page += option_entry(argument, true);
  }
  for (const CommandOption& option : command.options)
    if (option.names.back() != "--help") page += option_entry(option, false);
  return page;
}

bool same_options(const Command& a, const Command& b) {
  return std::equal(
      a.options.begin(), a.options.end(), b.options.begin(), b.options.end(),
      [](const auto& x, const auto& y) { return x.names == y.names; });
}

/// A nested verb equal to a verb of the program refers to it.
void append_verbs(std::string& page, const Command& program, const Command& parent,
                  const std::string& path) {
  for (const Command& verb : parent.verbs) {
    const std::string verb_path = path.empty() ? verb.name : path + " " + verb.name;
    page += ".SS \"" + escaped(verb_path) + arguments_of(verb) + "\"\n";
    page += paragraph(verb.help);
    const auto same =
        std::find_if(program.verbs.begin(), program.verbs.end(), [&](const Command& one) {
          return &parent != &program && one.name == verb.name && same_options(one, verb);
        });
    if (same != program.verbs.end()) {
      page += ".PP\nOptions as of " + bold(same->name) + ".\n";
      continue;
    }
    page += entries_of(verb);
    if (!verb.footer.empty() && verb.footer != program.footer)
      page += ".PP\n" + paragraph(verb.footer);
    append_verbs(page, program, verb, verb_path);
  }
}

void append_environment(std::string& page, const Command& command) {
  for (const CommandOption& option : command.options) {
    if (!option.environment.empty()) {
      page +=
          ".TP\n" + bold(option.environment) + "\nStands for " + bold(option.names.back()) + ".\n";
    }
  }
  for (const Command& verb : command.verbs) append_environment(page, verb);
}

}  // namespace

std::string man_page(const Command& program, int section, const std::string& version) {
  std::string page = fmt::format(
      ".\\\" Made by {} from what it prints as its help.\n"
      ".TH {} {} \"\" \"Hedgehog {}\" \"Hedgehog\"\n.nh\n.SH NAME\n",
      program.name, escaped(upper(program.name)), section, version);
  page += escaped(program.name) + " \\- " + escaped(summary(program)) + "\n";
  page += ".SH SYNOPSIS\n" + synopsis_of(program, program.name);
  page += ".SH DESCRIPTION\n" + paragraph(program.help);
  page += ".SH OPTIONS\n" + entries_of(program);
  if (!program.verbs.empty()) {
    page += ".SH VERBS\n";
    append_verbs(page, program, program, "");
  }
  if (!program.footer.empty()) page += ".SH \"EXIT STATUS\"\n" + paragraph(program.footer);
  std::string environment;
  append_environment(environment, program);
  if (!environment.empty()) page += ".SH ENVIRONMENT\n" + environment;
  page += ".SH \"SEE ALSO\"\n";
  constexpr std::array<std::string_view, 9> kPages{"hedgehogctl(1)",
                                                   "hedgehog\\-gamepad(1)",
                                                   "hedgehog\\-mqtt(1)",
                                                   "hedgehog\\-design(1)",
                                                   "hedgehog\\-orientation(1)",
                                                   "hedgehog\\-racer(1)",
                                                   "hedgehog\\-study(1)",
                                                   "hedgehogd(8)",
                                                   "hedgehog\\-simboard(8)"};
  std::string others;
  for (const std::string_view other : kPages)
    if (!other.starts_with(escaped(program.name) + "("))
      others += (others.empty() ? "" : ", ") + std::string(other);
  return page + others + "\n";
}

}  // namespace hedgehog::cli
