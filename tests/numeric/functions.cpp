// Compiled once per instruction set, as the kernels are.
#include "numeric/functions.h"

#include "numeric/number.h"
#include "numeric/warp.h"

namespace gonio::GONIO_ISA {
namespace {

using Quick = Double<Exactness::quick>;
using Exact = Double<Exactness::exact>;

template <class D>
void weighted_log2(const double* w, const double* s, const double* c, std::size_t n, double* out) {
  for (std::size_t i = 0; i < n; i += raw::kWidth) {
    const D sum = D::load(s + i) + D::load(c + i);
    weighted_log2_1p(D::load(w + i), D::load(s + i), D::load(c + i), sum).store(out + i);
  }
}

template <class N>
void exp2(const typename N::Out* amplitude, const double* x, std::size_t n, typename N::Out* out) {
  for (std::size_t i = 0; i < n; i += raw::kWidth) {
    const auto power = N::exp2(N::Wide::load(x + i));
    N::times_exp2(N::Real::load(amplitude + i), power).store(out + i);
  }
}

template <class D>
void angle(const double* y, const double* x, std::size_t n, double* out) {
  for (std::size_t i = 0; i < n; i += raw::kWidth)
    first_quadrant_angle(D::load(y + i), D::load(x + i)).store(out + i);
}

void divide(const double* a, const double* b, std::size_t n, double* out) {
  for (std::size_t i = 0; i < n; i += raw::kWidth)
    (Quick::load(a + i) / Quick::load(b + i)).store(out + i);
}

void product(const double* a, const double* b, std::size_t n, double* out, double* error) {
  for (std::size_t i = 0; i < n; i += raw::kWidth) {
    Exact rounded, lost;
    exact_product(Exact::load(a + i), Exact::load(b + i), rounded, lost);
    rounded.store(out + i), lost.store(error + i);
  }
}

template <class D>
void dot(const double* a, const double* b, std::size_t n, double* out) {
  const auto vector = [n](const double* at) -> Vec3<D> {
    return {D::load(at), D::load(at + n), D::load(at + 2 * n)};
  };
  for (std::size_t i = 0; i < n; i += raw::kWidth)
    exact_dot(vector(a + i), vector(b + i)).store(out + i);
}

template <class Packet, class Number>
void inverse_length(const Number* e, std::size_t n, Number* out) {
  for (std::size_t i = 0; i < n; i += raw::kWidth)
    Fast::inverse_length(Packet::load(e + i)).store(out + i);
}

template <class Packet, class Number>
void log2_of_rest(const Number* x, std::size_t n, Number* out) {
  for (std::size_t i = 0; i < n; i += raw::kWidth)
    log2_one_minus(Packet::load(x + i)).store(out + i);
}

template <class Packet, class Number>
void power_of_two(const Number* x, std::size_t n, Number* power, Number* one_minus) {
  for (std::size_t i = 0; i < n; i += raw::kWidth) {
    const auto found = exp2_of(Packet::load(x + i));
    found.power.store(power + i);
    found.one_minus.store(one_minus + i);
  }
}

template <class Packet, class Number>
void half_turns(const Number* x, std::size_t n, Number* cos, Number* sin) {
  for (std::size_t i = 0; i < n; i += raw::kWidth) {
    const auto found = half_turn(Packet::load(x + i));
    found.cos.store(cos + i);
    found.sin.store(sin + i);
  }
}

template <class Packet, class Number>
void turns(const Number* x, std::size_t n, Number* cos, Number* sin) {
  for (std::size_t i = 0; i < n; i += raw::kWidth) {
    const auto found = turn(Packet::load(x + i));
    found.cos.store(cos + i);
    found.sin.store(sin + i);
  }
}

}  // namespace

extern const testing::Functions kFunctions;  // NOLINT(readability-redundant-declaration): linkage
const testing::Functions kFunctions{&weighted_log2<Quick>,
                                    &weighted_log2<Exact>,
                                    &exp2<Fast>,
                                    &exp2<Reference>,
                                    &angle<Quick>,
                                    &angle<Exact>,
                                    &divide,
                                    &product,
                                    &dot<Quick>,
                                    &dot<Exact>,
                                    &inverse_length<Float>,
                                    &inverse_length<Quick>,
                                    &log2_of_rest<Float>,
                                    &log2_of_rest<Exact>,
                                    &power_of_two<Float>,
                                    &power_of_two<Exact>,
                                    &half_turns<Float>,
                                    &half_turns<Exact>,
                                    &turns<Float>,
                                    &turns<Exact>};

}  // namespace gonio::GONIO_ISA
