// Each bound of numeric/errors.h, with the search for the worst error that it bounds.
#pragma once

#include <span>
#include <string_view>

#include "numeric/worst/search.h"

namespace gonio::testing {

struct Bound {
  std::string_view name;  // in numeric/errors.h
  double stated;
  Worst (*search)(std::span<const Isa>);
  // Whether only AVX-512 is less than exact: other instruction sets cannot come near the bound.
  bool by_estimate = false;
};

std::span<const Bound> bounds();

Worst worst_times_exp2(std::span<const Isa> isas);
Worst worst_exact_times_exp2(std::span<const Isa> isas);
Worst worst_exp2(std::span<const Isa> isas);
Worst worst_one_minus_exp2(std::span<const Isa> isas);
Worst worst_exact_exp2(std::span<const Isa> isas);
Worst worst_exact_one_minus_exp2(std::span<const Isa> isas);

Worst worst_quick_weighted_log2(std::span<const Isa> isas);
Worst worst_exact_weighted_log2(std::span<const Isa> isas);
Worst worst_log2_one_minus(std::span<const Isa> isas);
Worst worst_exact_log2_one_minus(std::span<const Isa> isas);

Worst worst_quick_angle(std::span<const Isa> isas);
Worst worst_exact_angle(std::span<const Isa> isas);
Worst worst_half_turn(std::span<const Isa> isas);
Worst worst_turn(std::span<const Isa> isas);
Worst worst_exact_half_turn(std::span<const Isa> isas);
Worst worst_exact_turn(std::span<const Isa> isas);

Worst worst_quick_division(std::span<const Isa> isas);
Worst worst_inverse_length(std::span<const Isa> isas);
Worst worst_float_inverse_length(std::span<const Isa> isas);
Worst worst_exact_dot(std::span<const Isa> isas);

}  // namespace gonio::testing
