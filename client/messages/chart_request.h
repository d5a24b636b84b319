// What Client::chart sends. Internal to the client library. Thread safety: no state.
#pragma once

#include "gonio/base/result.h"
#include "gonio/client/chart.h"
#include "gonio/v1/chart.pb.h"

namespace gonio::client {

// Errors: a material that cannot be read; too many pairs; numbers for which 0 would mean the
// default.
Result<gonio::v1::ChartRequest> chart_request(const ChartOptions& options);

}  // namespace gonio::client
