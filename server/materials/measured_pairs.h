// Measured pairs that come with a request, and tables that one names. Thread safety: functions
// without state.
#pragma once

#include <cstddef>
#include <memory>

#include "fit/data/data.h"
#include "gonio/base/result.h"
#include "gonio/measured/table.h"
#include "gonio/v1/fit.pb.h"
#include "server/materials/materials.h"

namespace gonio::server {

// Cheap. Error: "pairs.channels".
Outcome check_pairs(const v1::MeasuredPairs& pairs);

// About what one pair of so many channels costs: the request, its copy in float64 and fit::Data.
std::size_t bytes_of_pair(std::size_t channels);

// Errors: arrays whose lengths do not agree, as "pairs....".
Result<fit::Data> data_of(const v1::MeasuredPairs& pairs);

// The table of a stored measured material. Errors: "measured...." for one that is not there or is
// no table.
Result<std::shared_ptr<const MeasuredTable>> table_of(const v1::Material& measured,
                                                      const Materials& materials);

}  // namespace gonio::server
