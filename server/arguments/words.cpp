#include "server/arguments/words.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/near_names.h"
#include "base/text/join.h"
#include "gonio/base/shown.h"

namespace gonio::arguments {
namespace {

// A validator's name holds its words: an option keeps a copy of the plain Validator, which has no
// other place for them.
constexpr const char* kOneOf = "one of";
constexpr const char* kSuggested = "suggested";

// Empty where the option has no such validator.
std::string name_of_first(CLI::Option& option) {
  try {
    return option.get_validator(0)->get_name();
  } catch (const CLI::OptionNotFound&) {
    return {};
  }
}

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

}  // namespace

CLI::Validator one_of(std::vector<std::string> words) {
  const std::string name = kOneOf + (" " + joined(words, " "));
  const auto check = [words = std::move(words)](std::string& given) -> std::string {
    if (std::find(words.begin(), words.end(), given) != words.end()) return {};
    return "\"" + shown(given, kQuotedLength) + "\" is not known; allowed: " + joined(words) +
           did_you_mean(given, std::span<const std::string>(words));
  };
  return {check, "", name};
}

CLI::Validator suggest(const std::vector<std::string>& words) {
  return {[](std::string&) { return std::string(); }, "", kSuggested + (" " + joined(words, " "))};
}

std::vector<std::string> words_of(CLI::Option& option) {
  const std::string name = name_of_first(option);
  for (const char* kind : {kOneOf, kSuggested}) {
    if (!begins_with(name, kind)) continue;
    std::istringstream rest(name.substr(std::string(kind).size()));
    std::vector<std::string> words;
    for (std::string word; rest >> word;) words.push_back(word);
    return words;
  }
  return {};
}

bool takes_only_words(CLI::Option& option) { return begins_with(name_of_first(option), kOneOf); }

}  // namespace gonio::arguments
