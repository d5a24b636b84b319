// What Client::assess sends. Internal to the client library. Thread safety: no state.
#pragma once

#include "gonio/base/result.h"
#include "gonio/client/assess.h"
#include "gonio/client/material.h"
#include "gonio/v1/assess.pb.h"

namespace gonio::client {

// Errors: a material that cannot be read; numbers for which 0 would mean the default.
Result<gonio::v1::AssessRequest> assess_request(const Material& material,
                                                const AssessOptions& options);

}  // namespace gonio::client
