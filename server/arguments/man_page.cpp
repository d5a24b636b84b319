#include "server/arguments/man_page.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "base/text/join.h"

namespace gonio::arguments {
namespace {

// Text as roff shows it: hyphens as they are typed, no line a request.
std::string roff(std::string_view text) {
  std::string escaped;
  bool at_start = true;
  for (const char c : text) {
    if (at_start && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') escaped += "\\e";
    if (c == '-') escaped += "\\-";
    if (c != '\\' && c != '-') escaped += c;
    at_start = c == '\n';
  }
  return escaped;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string dashed(const CLI::App& app, const std::string& program) {
  return program.empty() ? app.get_name() : program + "-" + app.get_name();
}

// The lines of a text that is laid out already.
std::string as_it_is(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\n');
  if (first == std::string_view::npos) return {};
  const std::size_t last = text.find_last_not_of('\n');
  return ".nf\n" + roff(text.substr(first, last + 1 - first)) + "\n.fi\n";
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string names_of(const CLI::Option& option) {
  std::vector<std::string> all;
  for (const std::string& name : option.get_snames()) all.push_back(bold("-" + name));
  for (const std::string& name : option.get_lnames()) all.push_back(bold("--" + name));
  std::string names = all.empty() ? italic(option.get_name(true)) : joined(all);
  if (option.get_type_size() > 0 && option.nonpositional() && !option.get_type_name().empty())
    names += " " + italic(option.get_type_name());
  return names;
}

std::string options_section(const CLI::App& app) {
  std::string text = ".SH OPTIONS\n";
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    text += ".TP\n" + names_of(*option) + "\n" + roff(option->get_description());
    if (option->get_required()) text += " (required)";
    if (!option->get_default_str().empty())
      text += " (default " + roff(option->get_default_str()) + ")";
    if (!option->get_envname().empty())
      text += " (environment: " + roff(option->get_envname()) + ")";
    text += "\n";
  }
  return text;
}

std::string commands_section(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_group().empty()) continue;
    text += ".TP\n" + bold(app.get_name() + "-" + command->get_name()) + "(1)\n" +
            roff(command->get_description()) + "\n";
  }
  return text.empty() ? text : ".SH COMMANDS\n" + text;
}

std::string synopsis(const CLI::App& app, const std::string& program) {
  const bool commands = !app.get_subcommands([](const CLI::App*) { return true; }).empty();
  std::string text =
      ".SH SYNOPSIS\n" + bold((program.empty() ? "" : program + " ") + app.get_name());
  text += commands ? " " + italic("COMMAND") + " [OPTIONS]" : " [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->nonpositional()) text += " [" + italic(option->get_name(true)) + "]";
  }
  return text + "\n";
}

}  // namespace

std::string man_page_name(const CLI::App& app, const std::string& program) {
  return dashed(app, program) + ".1";
}

std::string man_page(const CLI::App& app, const std::string& program, const std::string& version) {
  const std::string name = dashed(app, program);
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string text = ".TH " + roff(title) + " 1 \"\" \"" + roff(version) + "\" \"User Commands\"\n";
  text += ".SH NAME\n" + roff(name) + " \\- " + roff(first_line(app.get_description())) + "\n" +
          synopsis(app, program) + ".SH DESCRIPTION\n" + roff(app.get_description()) + "\n" +
          commands_section(app) + options_section(app);
  const std::string more = app.get_footer();
  if (!more.empty()) text += ".SH DETAILS\n" + as_it_is(more);
  return text;
}

}  // namespace gonio::arguments
