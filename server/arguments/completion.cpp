#include "server/arguments/completion.h"

#include <algorithm>

#include "base/text/join.h"
#include "server/arguments/words.h"

namespace gonio::arguments {
namespace {

bool is_shown(const CLI::Option* option) { return !option->get_group().empty(); }
bool takes_value(const CLI::Option* option) { return option->get_items_expected_max() > 0; }

std::vector<CLI::App*> commands_of(CLI::App& app) {
  return app.get_subcommands([](CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

// What a shell takes as one word, whatever is in it.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string option_names(CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (!is_shown(option)) continue;
    for (const std::string& name : names_of(*option)) names.push_back(name);
  }
  return joined(names, " ");
}

// "words='ggx ward'" of positional arguments, such as the models of `gonio models`.
std::string positional_words(CLI::App& app) {
  std::vector<std::string> words;
  bool only = false;
  for (CLI::Option* option : app.get_options()) {
    if (option->nonpositional()) continue;
    for (const std::string& word : words_of(*option)) words.push_back(word);
    only = only || takes_only_words(*option);
  }
  return "words=" + quoted(joined(words, " ")) + (only ? " only=1" : "");
}

// "    (evaluate:--isa) words='auto baseline' only=1 ;;" for each option that takes a value.
std::string value_cases(CLI::App& app, const std::string& command) {
  std::string text;
  for (CLI::Option* option : app.get_options()) {
    if (!is_shown(option) || !option->nonpositional() || !takes_value(option)) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : names_of(*option)) patterns.push_back(command + ":" + name);
    text += "    (" + joined(patterns, "|") +
            ") value=1 words=" + quoted(joined(words_of(*option), " "));
    text += takes_only_words(*option) ? " only=1 ;;\n" : " ;;\n";
  }
  return text;
}

constexpr const char* kBashHead = R"(
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command='' i
  # "--option=value" comes as three words.
  if [[ $cur == = ]]; then cur=''; elif [[ $prev == = ]]; then prev=${COMP_WORDS[COMP_CWORD-2]}; fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case ${COMP_WORDS[i]} in
)";
constexpr const char* kBashValues = R"(    esac
  done
  local words='' options='' value='' only=''
  case $command:$prev in
)";
constexpr const char* kBashOptions = R"(  esac
  if [[ -z $value ]]; then
    case $command in
)";
constexpr const char* kBashTail = R"(    esac
    [[ $cur == -* ]] && words=$options only=1
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
  [[ $only ]] || mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$cur")
}
)";

std::string bash_script(CLI::App& app) {
  const std::string name = app.get_name();
  const auto commands = commands_of(app);
  std::vector<std::string> names;
  std::string values = value_cases(app, ""), options;
  for (CLI::App* command : commands) {
    names.push_back(command->get_name());
    values += value_cases(*command, command->get_name());
    options += "      (" + command->get_name() + ") options=" + quoted(option_names(*command)) +
               " " + positional_words(*command) + " ;;\n";
  }
  std::string text =
      "# Completion for " + name + ", made by the program itself.\n_" + name + "() {";
  text += kBashHead;
  if (!names.empty())
    text += "      (" + joined(names, "|") + ") command=${COMP_WORDS[i]}; break ;;\n";
  text += kBashValues + values + kBashOptions + options;
  text += "      ('') options=" + quoted(option_names(app)) +
          " words=" + quoted(joined(names, " ")) + (names.empty() ? "" : " only=1") + " ;;\n";
  return text + kBashTail + "complete -o filenames -F _" + name + " " + name + "\n";
}

// zsh has bash's functions for this.
std::string zsh_script(CLI::App& app) {
  return "#compdef " + app.get_name() + "\nautoload -Uz bashcompinit && bashcompinit\n" +
         bash_script(app);
}

std::string fish_options(CLI::App& app, const std::string& start) {
  std::string text;
  for (CLI::Option* option : app.get_options()) {
    if (!is_shown(option)) continue;
    std::string line = start;
    for (const std::string& name : option->get_lnames()) line += " -l " + name;
    for (const std::string& name : option->get_snames()) line += " -s " + name;
    if (option->nonpositional() && takes_value(option)) line += " -r";
    if (takes_only_words(*option)) line += " -f";
    const auto words = words_of(*option);
    if (!words.empty()) line += " -a " + quoted(joined(words, " "));
    text += line + " -d " + quoted(option->get_description()) + "\n";
  }
  return text;
}

std::string fish_script(CLI::App& app) {
  const std::string start = "complete -c " + app.get_name();
  const auto commands = commands_of(app);
  const std::string first = commands.empty() ? "" : " -n __fish_use_subcommand";
  std::string text = "# Completion for " + app.get_name() + ", made by the program itself.\n" +
                     fish_options(app, start + first);
  for (CLI::App* command : commands) {
    text += start + first + " -f -a " + command->get_name() + " -d " +
            quoted(command->get_description()) + "\n" +
            fish_options(*command,
                         start + " -n '__fish_seen_subcommand_from " + command->get_name() + "'");
  }
  return text;
}

}  // namespace

const std::vector<std::string>& shells() {
  static const std::vector<std::string> all{"bash", "fish", "zsh"};
  return all;
}

std::string completion_script(CLI::App& app, std::string_view shell) {
  if (shell == "fish") return fish_script(app);
  return shell == "zsh" ? zsh_script(app) : bash_script(app);
}

}  // namespace gonio::arguments
