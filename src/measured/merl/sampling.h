// Draws directions for a measured isotropic material, from its own luminance.
//
// For some angles of incidence the half-vector's colatitude and its azimuth from wi's are divided
// into cells, finer towards the normal; a cell is drawn by the luminance f cos(theta_o) that it
// reflects, a half-vector in it evenly by solid angle. Between two angles either one's cells are
// drawn from, by how near they are. Half-vectors whose reflection is below the horizon are samples
// lost; only cells that the horizon crosses have any. 0.2 MB a material, whatever its table holds.
//
// Matusik, Pfister, Brand & McMillan 2003 sample their measurements like this, by the outgoing
// direction. Frame and units as in engine/evaluate.h. Thread safety: immutable.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "numeric/direction.h"

namespace gonio {

class TableSampling {
 public:
  // Writes the luminance of f, without a cosine, of each pair; 0 where it is not known.
  using Luminance = std::function<void(std::span<const Direction> wi, std::span<const Direction> wo,
                                       std::span<double> luminance)>;

  explicit TableSampling(const Luminance& luminance);

  // The direction for three numbers in [0, 1): `choice` of angle and side, u and v of the cell and
  // the place in it. wi is unit and above the horizon.
  [[nodiscard]] Direction draw(const Direction& wi, double choice, double u, double v) const;
  // Its density, per steradian of wo; 0 at and below the horizon.
  [[nodiscard]] double density(const Direction& wi, const Direction& wo) const;

  [[nodiscard]] std::size_t bytes() const { return sizeof(*this) + angles_.size() * sizeof(Angle); }

 private:
  static constexpr int kAngles = 24, kColatitudes = 64, kAzimuths = 32;

  // One angle of incidence: cumulated masses of the colatitudes, and of the azimuths of each.
  struct Angle {
    std::array<float, kColatitudes + 1> colatitude;
    std::array<std::array<float, kAzimuths + 1>, kColatitudes> azimuth;
  };
  struct Between {
    std::size_t lower;  // the angle below theta_i
    double weight;      // of the one above
  };
  static Between angles_beside(double cos_i);
  void tabulate(std::size_t angle, const Luminance& luminance);
  [[nodiscard]] double mass(const Angle& angle, std::size_t colatitude, std::size_t azimuth) const;

  std::array<double, kColatitudes + 1> edge_{};  // 1 - cos(theta_h) of the cells
  std::vector<Angle> angles_;
};

}  // namespace gonio
