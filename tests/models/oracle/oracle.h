// An independent oracle: f(wi, wo) of a material, written from the formula sheet alone.
//
// It takes what a person writes (a MaterialSpec) and reads the parameters by itself, so that a
// mistake in the library's parsing, preparation or formulas shows as a difference. Real is Quad for
// truth; long double shows how far truth depends on its own rounding.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gonio/engine/material.h"
#include "models/oracle/formulas.h"

namespace gonio::testing {

template <class Real>
class Oracle {
 public:
  // The specification must be a valid one; throws std::out_of_range for a model it does not know.
  explicit Oracle(const MaterialSpec& spec);

  [[nodiscard]] std::size_t channels() const { return channels_; }

  // f in 1/sr for every channel at the exactly normalised directions; 0 unless both z are above 0.
  void evaluate(Vec<Real> wi, Vec<Real> wo, std::span<Real> f) const;

 private:
  // A pair of directions with what every lobe needs of it.
  struct Pair {
    Vec<Real> wi, wo, h;
    Real hk;  // h.wi = h.wo
  };
  struct Lobe;

  static Lobe lobe_of(const LobeSpec& spec);
  static Real fresnel(const Lobe& lobe, Real c, std::size_t channel);
  static Real without_fresnel(const Lobe& lobe, const Pair& pair);
  static Real channel(const Lobe& lobe, const Pair& pair, Real shared, std::size_t c);
  static void add(const Lobe& lobe, const Pair& pair, std::span<Real> f);

  std::shared_ptr<const std::vector<Lobe>> lobes_;
  std::size_t channels_ = 1;
  Real rotation_ = 0;  // of the tangents, in degrees
};

extern template class Oracle<Quad>;
extern template class Oracle<long double>;

}  // namespace gonio::testing
