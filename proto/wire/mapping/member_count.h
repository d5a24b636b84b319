// How many members an aggregate has, at compile time. Thread safety: functions without state.
#pragma once

#include <cstddef>
#include <utility>

namespace gonio::wire {

// Stands for an initialiser of any type; never evaluated.
struct AnyInitialiser {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): implicit is the point
};

template <class T, std::size_t... Index>
constexpr bool takes_initialisers(std::index_sequence<Index...> /*count*/) {
  return requires { T{(static_cast<void>(Index), AnyInitialiser{})...}; };
}

// Of T without base classes, whose members have defaults.
template <class T, std::size_t Count = 0>
constexpr std::size_t member_count() {
  if constexpr (takes_initialisers<T>(std::make_index_sequence<Count + 1>{})) {
    return member_count<T, Count + 1>();
  } else {
    return Count;
  }
}

}  // namespace gonio::wire
