// An Assess request and its answer, in the core's terms. Thread safety: functions without state.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include "assess/assess.h"
#include "gonio/base/result.h"
#include "gonio/v1/assess.pb.h"

namespace gonio::server {

// Parses what has come. Errors: invalid_argument for bytes that are not such a message, and for a
// material that is too large.
Result<v1::AssessRequest> decode_assess_request(const grpc::ByteBuffer& buffer);

assess::Options assess_options(const v1::AssessRequest& request);

// Without the instruction set, which is the call's to add.
v1::AssessResponse to_wire(const assess::Assessment& assessment);

}  // namespace gonio::server
