// Error bounds of the functions of numeric/, stated only here; relative, but for angles and their
// sines and cosines. tests/numeric/proofs proves each on every instruction set, and checks that it
// is the proved one rounded up to three digits; the tests find errors of more than half of each.
#pragma once

namespace gonio::errors {

// elementary.h
inline constexpr double kTimesExp2Error = 2.96e-7;
inline constexpr double kExactTimesExp2Error = 3.15e-16;
inline constexpr double kQuickWeightedLog2Error = 3.59e-9;
inline constexpr double kExactWeightedLog2Error = 1.73e-15;
inline constexpr double kQuickAngleError = 5.69e-11;
inline constexpr double kExactAngleError = 3.93e-16;
inline constexpr double kExactDotError = 1.98e-16;

// warp.h
inline constexpr double kLog2OneMinusError = 3.89e-7;
inline constexpr double kExactLog2OneMinusError = 1.44e-15;
inline constexpr double kExp2Error = 9.93e-8;
inline constexpr double kOneMinusExp2Error = 1.48e-7;
inline constexpr double kExactExp2Error = 2.04e-16;
inline constexpr double kExactOneMinusExp2Error = 4.25e-16;
inline constexpr double kHalfTurnError = 3.93e-7;
inline constexpr double kTurnError = 1.09e-6;
inline constexpr double kExactHalfTurnError = 6.15e-16;
inline constexpr double kExactTurnError = 2.06e-15;

// packet.h and number.h
inline constexpr double kQuickDivisionError = 2.28e-13;
inline constexpr double kInverseLengthError = 1.31e-16;
inline constexpr double kFloatInverseLengthError = 6.27e-8;

}  // namespace gonio::errors
