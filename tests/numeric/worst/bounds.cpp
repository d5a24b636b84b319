#include "numeric/worst/bounds.h"

#include <array>

#include "numeric/errors.h"

namespace gonio::testing {
namespace {

#define GONIO_BOUND(name) #name, errors::name

constexpr std::array kBounds{
    Bound{GONIO_BOUND(kTimesExp2Error), &worst_times_exp2},
    Bound{GONIO_BOUND(kExactTimesExp2Error), &worst_exact_times_exp2},
    Bound{GONIO_BOUND(kQuickWeightedLog2Error), &worst_quick_weighted_log2},
    Bound{GONIO_BOUND(kExactWeightedLog2Error), &worst_exact_weighted_log2},
    Bound{GONIO_BOUND(kQuickAngleError), &worst_quick_angle},
    Bound{GONIO_BOUND(kExactAngleError), &worst_exact_angle},
    Bound{GONIO_BOUND(kExactDotError), &worst_exact_dot},
    Bound{GONIO_BOUND(kLog2OneMinusError), &worst_log2_one_minus},
    Bound{GONIO_BOUND(kExactLog2OneMinusError), &worst_exact_log2_one_minus},
    Bound{GONIO_BOUND(kExp2Error), &worst_exp2},
    Bound{GONIO_BOUND(kOneMinusExp2Error), &worst_one_minus_exp2},
    Bound{GONIO_BOUND(kExactExp2Error), &worst_exact_exp2},
    Bound{GONIO_BOUND(kExactOneMinusExp2Error), &worst_exact_one_minus_exp2},
    Bound{GONIO_BOUND(kHalfTurnError), &worst_half_turn},
    Bound{GONIO_BOUND(kTurnError), &worst_turn},
    Bound{GONIO_BOUND(kExactHalfTurnError), &worst_exact_half_turn},
    Bound{GONIO_BOUND(kExactTurnError), &worst_exact_turn},
    Bound{GONIO_BOUND(kQuickDivisionError), &worst_quick_division, true},
    Bound{GONIO_BOUND(kInverseLengthError), &worst_inverse_length},
    Bound{GONIO_BOUND(kFloatInverseLengthError), &worst_float_inverse_length}};

#undef GONIO_BOUND

}  // namespace

std::span<const Bound> bounds() { return kBounds; }

}  // namespace gonio::testing
