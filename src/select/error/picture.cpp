#include "select/error/picture.h"

#include <numbers>
#include <vector>

#include "gonio/engine/evaluate.h"
#include "select/error/colour.h"

namespace gonio::select {
namespace {

// The colour at one pair, from values [channel][pair].
template <class T>
Lab colour_at(const std::vector<T>& values, int channels, std::size_t pairs, std::size_t pair,
              double exposure) {
  const auto at = [&](std::size_t c) {
    const std::size_t channel = channels == 1 ? 0 : c;
    return exposure * static_cast<double>(values[channel * pairs + pair]);
  };
  return lab_of(at(0), at(1), at(2));
}

}  // namespace

Ratio picture_error(const Material& material, const fit::Data& data) {
  const std::size_t pairs = data.size();
  if (pairs == 0) return {};
  std::vector<double> found(pairs * static_cast<std::size_t>(material.channels()));
  evaluate(material,
           Batch<float, double>{data.incident(0), data.outgoing(0), pairs,
                                Values<double>::planar(found.data(), pairs), nullptr},
           best_isa());
  Ratio sum;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double exposure = std::numbers::pi * static_cast<double>(data.wi[2][i]);
    const double weight = static_cast<double>(data.weights[i]) * static_cast<double>(data.wo[2][i]);
    const Lab seen = colour_at(data.values, data.channels, pairs, i, exposure);
    const Lab shown = colour_at(found, material.channels(), pairs, i, exposure);
    sum.numerator += weight * delta_e(seen, shown);
    sum.denominator += weight;
  }
  return sum;
}

}  // namespace gonio::select
