// What a Fit request asks for, in the core's terms. Thread safety: functions without state.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <memory>

#include "fit/fit.h"
#include "gonio/base/result.h"
#include "gonio/v1/fit.pb.h"
#include "server/materials/materials.h"

namespace gonio::server {

struct FitTask {
  MaterialSpec form;
  fit::Options options;
  std::shared_ptr<const MeasuredTable> table;  // null: the data are the request's pairs
  std::size_t bytes = 0;                       // about what the fit holds, the request included
};

// Parses what has come. Errors: invalid_argument for bytes that are not such a message, and for
// materials that are too large: parsed they take many times their bytes.
Result<v1::FitRequest> decode_fit_request(const grpc::ByteBuffer& buffer);

// Cheap: the data are looked up, not yet taken apart. Errors name the field: "form.specular[0]...",
// "options....", "measured....", "pairs....".
Result<FitTask> fit_task(const v1::FitRequest& request, const Materials& materials);

// `task` must come from the same request. Errors: arrays whose lengths do not agree.
Result<fit::Data> fit_data(const v1::FitRequest& request, const FitTask& task);

}  // namespace gonio::server
