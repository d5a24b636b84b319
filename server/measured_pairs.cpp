#include "server/measured_pairs.h"

#include <string>
#include <vector>

#include "engine/material.h"

namespace gonio {
namespace {

template <class From>
std::vector<double> wide(const From& numbers) {
  return {numbers.begin(), numbers.end()};
}

Error within_pairs(Error error) {
  error.field = "pairs." + error.field;
  error.message = "pairs." + error.message;
  return error;
}

}  // namespace

Outcome check_pairs(const v1::MeasuredPairs& pairs) {
  const auto channels = static_cast<std::size_t>(pairs.channels());
  if (channels >= 1 && channels <= static_cast<std::size_t>(kMaxChannels)) return Ok{};
  return bad_value("pairs.channels", std::to_string(channels),
                   "1 to " + std::to_string(kMaxChannels));
}

std::size_t bytes_of_pair(std::size_t channels) {
  constexpr std::size_t kDirections = 6 * (4 + 8 + 4) + 16;
  return kDirections + 16 * channels;
}

Result<fit::Data> data_of(const v1::MeasuredPairs& pairs) {
  auto data = fit::from_pairs(wide(pairs.wi()), wide(pairs.wo()), wide(pairs.values()),
                              static_cast<int>(pairs.channels()), wide(pairs.weights()));
  if (!data) return within_pairs(data.error());
  return data;
}

}  // namespace gonio
