// Values at a place of the catalogue against truth. Thread safety: a function without state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "assess/report.h"

namespace gonio::assess {

// About `count` pairs at a place of places(); none where the material has no such place. Also none
// once `stop` says so: whoever asks must ask it again.
std::optional<PlaceReport> look_at(std::size_t place, const Subject& subject, std::size_t count,
                                   std::uint64_t seed, const std::function<bool()>& stop);

}  // namespace gonio::assess
