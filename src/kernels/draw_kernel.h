// Drawing samples a packet at a time, whatever draws one.
#pragma once

#include <type_traits>

#include "kernels/mixture_kernel.h"
#include "kernels/sampling_kernel.h"
#include "numeric/twofold.h"
#include "parts/half_vector_sampling.h"

namespace gonio::GONIO_ISA {

// The number system that draws to be stored as T are computed in.
template <class T>
using DrawNumbers = std::conditional_t<std::is_same_v<T, float>, TwofoldFast, Reference>;

template <class T, class DrawOne>
GONIO_INLINE void draw_with(const DrawRun<T>& given, const DrawOne& draw_one) {
  const auto run = given;  // a copy that no store can alias
  using N = DrawNumbers<T>;
  using Real = typename N::Real;
  const Real low(run.strategy - 0.5), high(run.strategy + 0.5);
  for (std::size_t i = 0; i < run.count; i += sizeof(Real) / sizeof(T)) {
    const Xi<Real> xi{Real::load(run.xi[0] + i), Real::load(run.xi[1] + i),
                      Real::load(run.xi[2] + i)};
    Vec3<Real> wo = draw_one(load_unit<N>(run.wi, i), xi);
    if (run.chosen != nullptr) {
      const Real chosen = Real::load(run.chosen + i);
      const auto mine = (low < chosen) & (chosen < high);
      wo.x = select(mine, wo.x, Real::load(run.wo[0] + i));
      wo.y = select(mine, wo.y, Real::load(run.wo[1] + i));
      wo.z = select(mine, wo.z, Real::load(run.wo[2] + i));
    }
    wo.x.store(run.wo[0] + i), wo.y.store(run.wo[1] + i), wo.z.store(run.wo[2] + i);
  }
}

}  // namespace gonio::GONIO_ISA
