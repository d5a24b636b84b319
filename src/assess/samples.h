// Compares samples for light from one direction with the integrals by quadrature. Thread safety: a
// function without state.
#pragma once

#include <cstdint>

#include "assess/energy.h"
#include "assess/report.h"

namespace gonio::assess {

Incidence sample_from(const Energy& energy, const Subject& subject, std::uint64_t seed);

}  // namespace gonio::assess
