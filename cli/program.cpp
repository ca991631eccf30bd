// SPDX-License-Identifier: MIT
#include "cli/program.h"

#include <sysexits.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>

#include "cli/error_message.h"
#include "cli/reference.h"

namespace hedgehog::cli {

CommandSpec CommandSpec::add_command(const std::string& name, const std::string& help) const {
  return CommandSpec(app_->add_subcommand(name, help));
}

void CommandSpec::require_commands(int min, int max) const {
  app_->require_subcommand(static_cast<std::size_t>(min), static_cast<std::size_t>(max));
}

void CommandSpec::accept_options_above() const { app_->fallthrough(); }

void CommandSpec::set_footer(const std::string& text) const { app_->footer(text); }

void CommandSpec::on_given(std::function<void()> act) const { app_->callback(std::move(act)); }

void CommandSpec::require_any_of(const OptionSpec& one, const OptionSpec& other,
                                 const std::string& what) const {
  app_->parse_complete_callback([one = one.option_, other = other.option_, what] {
    if (one->count() + other->count() == 0) throw CLI::RequiredError(what);
  });
}

bool CommandSpec::is_given() const { return app_->parsed(); }

bool CommandSpec::is_given(const std::string& name) const { return app_->got_subcommand(name); }

bool CommandSpec::has_given_command() const { return !app_->get_subcommands().empty(); }

Program::Program(const std::string& about, const std::string& name)
    : CommandSpec(nullptr), owned_(std::make_unique<CLI::App>(about, name)) {
  app_ = owned_.get();
}

Program::~Program() = default;

void Program::set_version(const std::string& text) { app_->set_version_flag("--version", text); }

std::optional<EarlyExit> Program::parse(const std::vector<std::string>& arguments, int section) {
  if (const auto code = write_reference(*app_, arguments, section)) return EarlyExit{*code, ""};
  try {
    app_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success& done) {
    std::ostringstream text;
    return EarlyExit{app_->exit(done, text, text), text.str()};
  } catch (const CLI::ParseError& error) {
    return EarlyExit{EX_USAGE, usage_error(error_message(*app_, error))};
  }
  return std::nullopt;
}

std::optional<int> Program::parse_and_print(int argc, const char* const* argv, int section) {
  const auto ended = parse({argv + 1, argv + argc}, section);
  if (!ended) return std::nullopt;
  if (ended->code == EX_USAGE)
    std::fprintf(stderr, "%s\n", ended->text.c_str());
  else
    std::fputs(ended->text.c_str(), stdout);
  return ended->code;
}

std::string Program::usage_error(const std::string& what) const {
  return cli::usage_error(*app_, what);
}

}  // namespace hedgehog::cli
