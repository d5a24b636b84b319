// Values at a place of the catalogue against truth. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "assess/report.h"

namespace gonio::assess {

// About `count` pairs at a place of places(); none where the material has no such place. Also none
// after `stop` returned true, which the caller must check.
std::optional<PlaceReport> look_at(std::size_t place, const Subject& subject, std::size_t count,
                                   std::uint64_t seed, const std::function<bool()>& stop);

// Relative errors of all values to which the bounds apply, for statistics.
struct ErrorList {
  std::vector<double> relative;  // of proper values
  std::uint64_t improper = 0;    // NaN, infinite and negative values above the horizon
};
struct PlaceErrors {
  ErrorList fast, reference;
  ErrorList naive32, naive64;  // with the pairs of `fast`; empty where no such form is known
};

// Adds the errors of about `count` pairs at a place.
void add_errors_at(std::size_t place, const Subject& subject, std::size_t count, std::uint64_t seed,
                   PlaceErrors& errors);

}  // namespace gonio::assess
