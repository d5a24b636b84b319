// Fits between the client's types and the wire's messages. Internal to the client library. Thread
// safety: no state.
#pragma once

#include "base/result.h"
#include "client/fit.h"
#include "gonio/v1/fit.pb.h"

namespace gonio::client {

// The pairs.
void fill(const FitData& from, gonio::v1::MeasuredPairs& to);

// Errors: a material that cannot be read.
Result<gonio::v1::FitRequest> fit_request(const FitData& data, const Material& form,
                                          const FitOptions& options);
FitProgress progress_of(const gonio::v1::FitProgress& progress);
Result<FitResult> fit_result_of(const gonio::v1::FitResult& result);

}  // namespace gonio::client
