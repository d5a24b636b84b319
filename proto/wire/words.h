// Enums of the wire that have the words of an enum of the core in the same order, after one for the
// default. Thread safety: functions without state.
#pragma once

#include <initializer_list>
#include <utility>

namespace gonio::wire {

template <class Wire, class Own>
constexpr Wire word_of(Own own) {
  return static_cast<Wire>(static_cast<int>(own) + 1);
}

// Whether the wire's enum has exactly these words, for static_assert.
template <class Own, class Wire>
constexpr bool same_words(std::initializer_list<std::pair<Own, Wire>> words, Wire last) {
  for (const auto& [own, wire] : words) {
    if (word_of<Wire>(own) != wire) return false;
  }
  return static_cast<int>(words.size()) == static_cast<int>(last);
}

}  // namespace gonio::wire
