// What a misspelt name may have meant: one measure of nearness for commands, options, models,
// parameters, words and stored names. Thread safety: functions without state.
//
// Two names are as far apart as Damerau's distance says: characters left out, put in, replaced, and
// neighbours exchanged, in lower case and without the '-', '_' and ' ' between words. A name within
// another one (of three characters and more) is as near as one edit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gonio/base/result.h"

namespace gonio {

// The candidate most like `name`; none where all are too far: a third of its length, two at least,
// one of names up to three characters.
std::optional<std::string> nearest_name(std::string_view name,
                                        std::span<const std::string_view> candidates);
std::optional<std::string> nearest_name(std::string_view name,
                                        std::span<const std::string> candidates);

// The end of an error's "allowed": "; did you mean \"copper\"?", or nothing.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates);
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

// bad_value() for a word that is not among those known: all of them are allowed, and the nearest is
// asked for. `known` holds one at least.
Error unknown_word(std::string_view field, std::string_view given,
                   std::span<const std::string_view> known,
                   ErrorCode code = ErrorCode::invalid_argument);
Error unknown_word(std::string_view field, std::string_view given,
                   std::span<const std::string> known,
                   ErrorCode code = ErrorCode::invalid_argument);

// The candidates most like `name`, in a sentence's form: "gold, old-gold"; where none is alike, the
// first few and how many more there are; "none" where there is nothing at all.
std::string near_names(std::string_view name, std::span<const std::string> candidates);

}  // namespace gonio
