// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "cli/program.h"

namespace hedgehog::cli {

std::optional<double> number_of(const std::string& text) {
  double number = 0.0;
  return CLI::detail::lexical_cast(text, number) ? std::optional(number) : std::nullopt;
}

OptionSpec OptionSpec::required() const {
  option_->required();
  return *this;
}

OptionSpec OptionSpec::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

OptionSpec OptionSpec::environment(const std::string& name) const {
  option_->envname(name);
  return *this;
}

OptionSpec OptionSpec::one_of(std::initializer_list<std::string> values) const {
  option_->check(CLI::IsMember(std::vector(values)));
  return *this;
}

OptionSpec OptionSpec::one_of(std::initializer_list<int> values) const {
  option_->check(CLI::IsMember(std::vector(values)));
  return *this;
}

OptionSpec OptionSpec::range(int min, int max) const {
  option_->check(CLI::Range(min, max));
  return *this;
}

OptionSpec OptionSpec::range(std::uint64_t min, std::uint64_t max) const {
  option_->check(CLI::Range(min, max));
  return *this;
}

OptionSpec OptionSpec::range(double min, double max) const {
  option_->check(CLI::Range(min, max));
  return *this;
}

OptionSpec OptionSpec::positive() const {
  option_->check(CLI::PositiveNumber);
  return *this;
}

OptionSpec OptionSpec::non_negative() const {
  option_->check(CLI::NonNegativeNumber.description(""));
  return *this;
}

OptionSpec OptionSpec::existing_folder() const {
  option_->check(CLI::ExistingDirectory);
  return *this;
}

OptionSpec OptionSpec::check(const Validator& validator) const {
  // CLI11's own type may also change the value.
  option_->check(CLI::Validator(
      [check = validator.check](std::string& text) { return check(text); }, validator.description));
  return *this;
}

OptionSpec OptionSpec::delimiter(char separator) const {
  option_->delimiter(separator);
  return *this;
}

OptionSpec OptionSpec::repeatable() const {
  option_->take_all()->expected(1);
  return *this;
}

OptionSpec OptionSpec::optional_value() const {
  option_->expected(0, 1);
  return *this;
}

OptionSpec OptionSpec::show_default() const {
  option_->capture_default_str();
  return *this;
}

OptionSpec OptionSpec::excludes(const OptionSpec& other) const {
  option_->excludes(other.option_);
  return *this;
}

OptionSpec OptionSpec::needs(const OptionSpec& other) const {
  option_->needs(other.option_);
  return *this;
}

template <class T>
OptionSpec CommandSpec::add_option(const std::string& names, T& value,
                                   const std::string& help) const {
  return OptionSpec(app_->add_option(names, value, help));
}

using Text = const std::string&;
template OptionSpec CommandSpec::add_option(Text, std::string&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::optional<std::string>&, Text) const;
template OptionSpec CommandSpec::add_option(Text, int&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::optional<int>&, Text) const;
template OptionSpec CommandSpec::add_option(Text, unsigned&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::optional<unsigned>&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::int64_t&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::optional<std::int64_t>&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::uint64_t&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::optional<std::uint64_t>&, Text) const;
template OptionSpec CommandSpec::add_option(Text, double&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::optional<double>&, Text) const;
template OptionSpec CommandSpec::add_option(Text, std::vector<std::string>&, Text) const;

OptionSpec CommandSpec::add_option_function(const std::string& names,
                                            const std::function<void(const std::string&)>& take,
                                            const std::string& help) const {
  return OptionSpec(app_->add_option_function<std::string>(names, take, help));
}

OptionSpec CommandSpec::add_flag(const std::string& names, bool& value,
                                 const std::string& help) const {
  return OptionSpec(app_->add_flag(names, value, help));
}

void CommandSpec::add_ignored_flag(const std::string& names) const {
  app_->add_flag(names)->group("");
}

OptionSpec CommandSpec::option(const std::string& name) const {
  return OptionSpec(app_->get_option(name));
}

}  // namespace hedgehog::cli
