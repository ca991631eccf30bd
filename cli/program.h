// SPDX-License-Identifier: MIT
// The command line of a program: its commands (verbs), options and arguments, and their parsing.
// CLI11 does the work; its header, which takes a compiler seconds, is included by this layer only.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
class Option;
}  // namespace CLI

namespace hedgehog::cli {

struct Validator {
  /// Returns what is wrong with a value; empty: nothing.
  std::function<std::string(const std::string&)> check{};
  /// Of the allowed values, in help texts; empty: none.
  std::string description{};
};

/// `text` as a number; nullopt: it is none, or not wholly.
std::optional<double> number_of(const std::string& text);

/// Handle to one option or positional argument; valid while its Program exists.
class OptionSpec {
 public:
  explicit OptionSpec(CLI::Option* option) : option_(option) {}

  OptionSpec required() const;
  /// Placeholder of its value in help texts, "FILE".
  OptionSpec type_name(const std::string& name) const;
  /// The environment variable that sets it when the command line does not.
  OptionSpec environment(const std::string& name) const;
  OptionSpec one_of(std::initializer_list<std::string> values) const;
  OptionSpec one_of(std::initializer_list<int> values) const;
  /// Inclusive.
  OptionSpec range(int min, int max) const;
  OptionSpec range(std::uint64_t min, std::uint64_t max) const;
  OptionSpec range(double min, double max) const;
  OptionSpec positive() const;
  OptionSpec non_negative() const;
  OptionSpec existing_folder() const;
  OptionSpec check(const Validator& validator) const;
  /// Separates the values of a list.
  OptionSpec delimiter(char separator) const;
  /// One value each time it is given; all of them count.
  OptionSpec repeatable() const;
  /// May be given without a value.
  OptionSpec optional_value() const;
  /// Help texts contain the present value of its variable as the default.
  OptionSpec show_default() const;
  OptionSpec excludes(const OptionSpec& other) const;
  OptionSpec needs(const OptionSpec& other) const;

 private:
  friend class CommandSpec;
  CLI::Option* option_;
};

/// Handle to a command of the program, or to the program itself; valid while its Program exists.
class CommandSpec {
 public:
  /// `names`: "-f,--follow", or "file" for a positional argument. `value` keeps its value if the
  /// command line has none, and must outlive the parsing. T: std::string, int, std::int64_t,
  /// std::uint64_t, unsigned, double, std::optional of one of them, std::vector<std::string>.
  template <class T>
  OptionSpec add_option(const std::string& names, T& value, const std::string& help = "") const;
  /// `take` is called with each value.
  OptionSpec add_option_function(const std::string& names,
                                 const std::function<void(const std::string&)>& take,
                                 const std::string& help) const;
  OptionSpec add_flag(const std::string& names, bool& value, const std::string& help) const;
  /// Without effect: accepted for compatibility and not in help texts.
  void add_ignored_flag(const std::string& names) const;
  /// REQUIRES: it was added, "--direction".
  OptionSpec option(const std::string& name) const;

  CommandSpec add_command(const std::string& name, const std::string& help) const;
  /// Number of its commands on a command line.
  void require_commands(int min, int max) const;
  /// Options of the commands above are also accepted behind it.
  void accept_options_above() const;
  /// At the end of its help text.
  void set_footer(const std::string& text) const;
  /// Called when it has been given, after parsing.
  void on_given(std::function<void()> act) const;
  /// Otherwise parsing fails: "<what> is required".
  void require_any_of(const OptionSpec& one, const OptionSpec& other,
                      const std::string& what) const;
  /// Of a parsed command line.
  bool is_given() const;
  /// The same for its command of that name.
  bool is_given(const std::string& name) const;
  /// One of its commands was given.
  bool has_given_command() const;

 protected:
  explicit CommandSpec(CLI::App* app) : app_(app) {}
  CLI::App* app_;
};

/// The end of a program by its command line alone.
struct EarlyExit {
  /// 0 after --help and --version; 64 (EX_USAGE); of --reference also 73 (EX_CANTCREAT).
  int code;
  /// What --help or --version print, for stdout; after a usage error its sentence, for stderr.
  /// Without LF at the end of a sentence.
  std::string text;
};

class Program : public CommandSpec {
 public:
  Program(const std::string& about, const std::string& name);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// What --version prints.
  void set_version(const std::string& text);
  /// `arguments`: without the program's name. Also handles --reference (reference.h); `section`: of
  /// its man page. nullopt: the variables are set.
  std::optional<EarlyExit> parse(const std::vector<std::string>& arguments, int section = 1);
  /// The same; prints the text of an early exit and returns its code.
  std::optional<int> parse_and_print(int argc, const char* const* argv, int section = 1);
  /// "hedgehogctl pulse: <what>; see hedgehogctl pulse --help", with the commands that were
  /// given.
  std::string usage_error(const std::string& what) const;

 private:
  std::unique_ptr<CLI::App> owned_;
};

}  // namespace hedgehog::cli
