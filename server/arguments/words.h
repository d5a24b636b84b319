// Options that take one of a few words. Thread safety: functions without state.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace gonio::arguments {

// One of the words and nothing else; errors list them and ask for the nearest.
CLI::Validator one_of(std::vector<std::string> words);
// Anything, but these words are what a shell may complete.
CLI::Validator suggest(const std::vector<std::string>& words);

// The words of an option that has one of these; none of others.
std::vector<std::string> words_of(CLI::Option& option);
// Whether an option takes its words alone.
bool takes_only_words(CLI::Option& option);

}  // namespace gonio::arguments
