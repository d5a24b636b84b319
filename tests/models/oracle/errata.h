// What an erratum is: a number that a printed form gets wrong and that the library gets right.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "models/oracle/cases.h"
#include "models/oracle/run.h"

namespace gonio::testing {

inline constexpr double kDegree = std::numbers::pi / 180;

inline Vec<double> at(double theta_degrees, double phi_degrees = 0) {
  const double t = theta_degrees * kDegree, p = phi_degrees * kDegree;
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

struct Erratum {
  std::string name;
  double printed;  // the measure with the printed form
  double library;  // and with the library
  double right;    // what it must be; or at most be, where the printed form has no one value
  double tolerance;
  bool bound = false;  // `right` is an upper bound
  double sheet = 0;    // the number that is known of the printed form; 0 if none
  double sheet_tolerance = 5e-4;

  [[nodiscard]] bool accepts(double measure) const {
    return bound ? measure <= right + tolerance : std::abs(measure - right) <= tolerance;
  }
};

// The printed form fails and the library passes.
inline void expect_mended(const std::vector<Erratum>& errata) {
  for (const Erratum& e : errata) {
    EXPECT_FALSE(e.accepts(e.printed)) << e.name << ": the printed form gives " << e.printed;
    EXPECT_TRUE(e.accepts(e.library))
        << e.name << ": the library gives " << e.library << ", not " << e.right;
    if (e.sheet == 0) continue;
    EXPECT_NEAR(e.printed, e.sheet, e.sheet_tolerance) << e.name;
  }
}

}  // namespace gonio::testing
