// What a Select request asks for, in the core's terms. Thread safety: functions without state.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <optional>

#include "fit/data/data.h"
#include "gonio/base/result.h"
#include "gonio/v1/select.pb.h"
#include "select/select.h"
#include "server/materials/materials.h"

namespace gonio::server {

struct SelectTask {
  select::Scene scene;
  select::Options options;
  std::optional<PreparedMaterial> material;  // none: the pairs
  v1::MeasuredPairs pairs;
  std::size_t bytes = 0;  // about what the selection holds, the request included
};

// Parses what has come. Errors: as decode_fit_request().
Result<v1::SelectRequest> decode_select_request(const grpc::ByteBuffer& buffer);

// Cheap: the scene and the options are checked, the material is looked up. Errors name the field:
// "scene....", "options....", "material....", "pairs....", "reference" where there is none.
Result<SelectTask> select_task(v1::SelectRequest request, const Materials& materials);

// Takes the pairs from the task. Errors: arrays whose lengths do not agree.
Result<fit::Data> select_data(SelectTask& task);

}  // namespace gonio::server
