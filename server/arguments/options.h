// Adding options and commands to a program's arguments, without the headers of CLI11: these cost
// four seconds of compiling in each file that includes them, and here only the functions below do.
// What the functions and their parameters mean is as in CLI11, which has the same names.
// Thread safety: used by one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
class Option;
}  // namespace CLI

namespace gonio::arguments {

// An option or a flag of a command, to be described further. Copies mean the same option.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  // What stands for the value in the help: "FILE".
  const Option& type_name(const std::string& name) const;
  const Option& required() const;
  const Option& excludes(const Option& other) const;
  // Separates the values of one argument.
  const Option& delimiter(char separator) const;
  const Option& environment(const std::string& variable) const;
  // One value each time that the option is given, and not all that follow it.
  const Option& one_value_a_time() const;
  const Option& default_value(std::int64_t value) const;

  // Takes one of the words and nothing else; errors list them and ask for the nearest.
  const Option& one_of(const std::vector<std::string>& words) const;
  // Takes anything, but these words are what a shell may complete.
  const Option& suggest(const std::vector<std::string>& words) const;
  // Takes numbers of the type Value from `least` to `most`, both included.
  template <class Value>
  const Option& range(Value least, Value most) const;

 private:
  CLI::Option* option_;
};

// Adds an option that sets `value`. Value: std::string, double, the integers of 32 and 64 bits
// (unsigned, and signed), or std::optional or std::vector of double or std::string.
template <class Value>
Option add_option(CLI::App& command, const std::string& names, Value& value,
                  const std::string& help);

Option add_flag(CLI::App& command, const std::string& names, bool& value, const std::string& help);

// An option that was added before.
Option find_option(CLI::App& command, const std::string& name);
void remove_option(CLI::App& command, const std::string& name);

// Adds a command with a text below its options' help.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& help,
                      const std::string& footer = "");
void set_footer(CLI::App& command, const std::string& footer);

}  // namespace gonio::arguments
