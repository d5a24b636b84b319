// Measured reflectance as a fit takes it: pairs of directions, values and weights.
//
// Directions are unit, in the local frame of engine/evaluate.h; values are in 1/sr, without a
// cosine. A pair's weight is the measure of pairs of directions (in sr^2) that it stands for: all
// pairs over the hemisphere together measure 4 pi^2. Cosines come in with the objective, not here.
// Thread safety: plain data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/engine/evaluate.h"
#include "gonio/fit/certificate.h"

namespace gonio {
class MeasuredTable;  // measured/table.h
}

namespace gonio::fit {

struct Data {
  int channels = 0;
  std::array<std::vector<float>, 3> wi, wo;  // x, y, z
  std::vector<float> weights;
  std::vector<float> values;  // channel c of pair i at [c * size() + i]
  LeftOut left_out;

  [[nodiscard]] std::size_t size() const { return weights.size(); }
  [[nodiscard]] std::span<const float> channel(int c) const {
    return std::span(values).subspan(static_cast<std::size_t>(c) * size(), size());
  }
  [[nodiscard]] Directions<float> incident(std::size_t first) const {
    return Directions<float>::separate(&wi[0][first], &wi[1][first], &wi[2][first]);
  }
  [[nodiscard]] Directions<float> outgoing(std::size_t first) const {
    return Directions<float>::separate(&wo[0][first], &wo[1][first], &wo[2][first]);
  }
};

// Arrays of pairs: interleaved xyz, values pair by pair ([pair][channel]). Without `weights` every
// pair weighs the same, 4 pi^2 / pairs. Errors: invalid_argument for lengths that do not agree, a
// number of channels outside 1 to 64, or values so small that float32 has not all their digits. Bad
// entries are no error: they are left out and counted.
Result<Data> from_pairs(std::span<const double> wi, std::span<const double> wo,
                        std::span<const double> values, int channels,
                        std::span<const double> weights = {});

// The cells of a MERL table at their centres. The weight is the exact measure of the pairs that
// fall into a cell; cells without a measurement are left out as `negative`.
Data from_table(const MeasuredTable& table);

// The measure of all cells [theta_h][theta_d] summed over the given phi_d: what from_table weighs
// by. Every cell's part above the horizon counts; all cells together measure 4 pi^2.
double cell_measure(int theta_h, int theta_d, int phi_d);

// The pairs at `kept`, in that order, their weights times `factor`.
Data pick(const Data& data, std::span<const std::size_t> kept, double factor);

// The pairs for which min < max(theta_i, theta_o) <= max (radians). `left_out` is that of `data`.
Data within(const Data& data, double min_theta, double max_theta);

// About `count` pairs, one of each of as many equal runs of consecutive pairs, chosen by `seed`.
// The weights grow so that they stand for all. The whole, if it is not larger.
Data subset(const Data& data, std::size_t count, std::uint64_t seed);

}  // namespace gonio::fit
