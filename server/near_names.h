// What a misspelt name may have meant. Thread safety: functions without state.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gonio {

// The candidates most like `name`, in a sentence's form: "gold, old-gold"; where none is alike, the
// first few and how many more there are; "none" where there is nothing at all.
std::string near_names(std::string_view name, std::span<const std::string> candidates);

}  // namespace gonio
