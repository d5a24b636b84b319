#include "server/arguments/options.h"

#include <CLI/CLI.hpp>

#include "server/arguments/words.h"

namespace gonio::arguments {

const Option& Option::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

const Option& Option::delimiter(char separator) const {
  option_->delimiter(separator);
  return *this;
}

const Option& Option::environment(const std::string& variable) const {
  option_->envname(variable);
  return *this;
}

const Option& Option::one_value_a_time() const {
  option_->allow_extra_args(false);
  return *this;
}

const Option& Option::default_value(std::int64_t value) const {
  option_->default_val(value);
  return *this;
}

const Option& Option::one_of(const std::vector<std::string>& words) const {
  option_->check(arguments::one_of(words));
  return *this;
}

const Option& Option::suggest(const std::vector<std::string>& words) const {
  option_->check(arguments::suggest(words));
  return *this;
}

// No description: it would stand in the help after the type's name.
template <class Value>
const Option& Option::range(Value least, Value most) const {
  option_->check(CLI::Range(least, most).description(""));
  return *this;
}

template <class Value>
Option add_option(CLI::App& command, const std::string& names, Value& value,
                  const std::string& help) {
  return Option(command.add_option(names, value, help));
}

Option add_flag(CLI::App& command, const std::string& names, bool& value, const std::string& help) {
  return Option(command.add_flag(names, value, help));
}

Option find_option(CLI::App& command, const std::string& name) {
  return Option(command.get_option(name));
}

void remove_option(CLI::App& command, const std::string& name) {
  command.remove_option(command.get_option(name));
}

CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help,
                      const std::string& footer) {
  CLI::App* command = app.add_subcommand(name, help);
  if (!footer.empty()) command->footer(footer);
  return *command;
}

void set_footer(CLI::App& command, const std::string& footer) { command.footer(footer); }

template const Option& Option::range(int, int) const;
template const Option& Option::range(unsigned, unsigned) const;
template const Option& Option::range(std::uint64_t, std::uint64_t) const;
template const Option& Option::range(double, double) const;

template Option add_option(CLI::App&, const std::string&, std::string&, const std::string&);
template Option add_option(CLI::App&, const std::string&, int&, const std::string&);
template Option add_option(CLI::App&, const std::string&, unsigned&, const std::string&);
template Option add_option(CLI::App&, const std::string&, std::int64_t&, const std::string&);
template Option add_option(CLI::App&, const std::string&, std::uint64_t&, const std::string&);
template Option add_option(CLI::App&, const std::string&, double&, const std::string&);
template Option add_option(CLI::App&, const std::string&, std::optional<double>&,
                           const std::string&);
template Option add_option(CLI::App&, const std::string&, std::vector<double>&, const std::string&);
template Option add_option(CLI::App&, const std::string&, std::vector<std::string>&,
                           const std::string&);

}  // namespace gonio::arguments
