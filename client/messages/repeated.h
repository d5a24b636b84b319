// A message's repeated fields as the client's values. Internal to the client library. Thread
// safety: functions without state.
#pragma once

#include <google/protobuf/repeated_field.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace gonio::client {

template <class To, class From>
std::vector<To> list(const From& from) {
  return {from.begin(), from.end()};
}

// Each converted.
template <class From, class Convert>
auto all(const From& from, const Convert& convert) {
  std::vector<decltype(convert(from[0]))> to;
  to.reserve(static_cast<std::size_t>(from.size()));
  for (const auto& element : from) to.push_back(convert(element));
  return to;
}

// What is not there is 0.
inline std::array<double, 3> direction_of(const google::protobuf::RepeatedField<double>& from) {
  std::array<double, 3> to{};
  std::copy_n(from.begin(), std::min(from.size(), 3), to.begin());
  return to;
}

}  // namespace gonio::client
