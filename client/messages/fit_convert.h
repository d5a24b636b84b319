// Fits between the client's types and the wire's messages. Internal to the client library. Thread
// safety: no state.
#pragma once

#include <cstddef>

#include "gonio/base/result.h"
#include "gonio/client/fit.h"
#include "gonio/v1/fit.pb.h"
#include "wire/message.h"

namespace gonio::client {

// Whether a message can hold the pairs. Error: resource_exhausted for more than `limit` bytes.
Outcome check_size(const FitData& data, std::size_t limit = wire::kLargestMessage);

// The pairs, whose size has been checked.
void fill(const FitData& from, gonio::v1::MeasuredPairs& to);

// Errors: a material that cannot be read; too many pairs.
Result<gonio::v1::FitRequest> fit_request(const FitData& data, const Material& form,
                                          const FitOptions& options);
FitProgress progress_of(const gonio::v1::FitProgress& progress);
Result<FitResult> fit_result_of(const gonio::v1::FitResult& result);

}  // namespace gonio::client
