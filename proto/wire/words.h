// Enums of the wire that have another's words in the same order. Thread safety: functions without
// state.
#pragma once

#include <initializer_list>
#include <utility>

namespace gonio::wire {

// How far a word's number on the wire is from the enum's own: 1 where only the wire has one for the
// default, 0 where the enum has one for what is not known.
template <class Wire, class Own>
constexpr Wire word_of(Own own, int shift = 1) {
  return static_cast<Wire>(static_cast<int>(own) + shift);
}

// Whether that is so of these words, and they are all that the wire has beside its 0: for
// static_assert.
template <class Own, class Wire>
constexpr bool same_words(std::initializer_list<std::pair<Own, Wire>> words, Wire last,
                          int shift = 1) {
  for (const auto& [own, wire] : words) {
    if (word_of<Wire>(own, shift) != wire) return false;
  }
  return static_cast<int>(words.size()) == static_cast<int>(last);
}

}  // namespace gonio::wire
