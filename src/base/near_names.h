// Suggestions for a misspelt name: one distance for commands, options, models, parameters, words
// and stored names. Thread safety: functions without state.
//
// The distance is Damerau's: the number of characters left out, put in or replaced, and of
// neighbours exchanged, after conversion to lower case and without '-', '_' and ' '. A name of
// three characters and more that is part of the other one has distance 1.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// The candidate nearest to `name`; none where all are farther than a third of its length (but at
// least 2, and 1 for names of up to three characters).
std::optional<std::string> nearest_name(std::string_view name,
                                        std::span<const std::string_view> candidates);
std::optional<std::string> nearest_name(std::string_view name,
                                        std::span<const std::string> candidates);

// The end of an error's "allowed": "; did you mean \"copper\"?", or nothing.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

// bad_value() for an unknown word: the error lists all known ones as allowed and suggests the
// nearest. `known` is not empty.
Error unknown_word(std::string_view field, std::string_view given,
                   std::span<const std::string_view> known,
                   ErrorCode code = ErrorCode::invalid_argument);
Error unknown_word(std::string_view field, std::string_view given,
                   std::span<const std::string> known,
                   ErrorCode code = ErrorCode::invalid_argument);

// The candidates nearest to `name` as text: "gold, old-gold". Where none is near: the first few,
// and how many more there are. "none" where there are no candidates.
std::string near_names(std::string_view name, std::span<const std::string> candidates);

}  // namespace gonio
