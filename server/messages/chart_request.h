// A Chart request and its answer, in the core's terms. Thread safety: functions without state.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "chart/machine.h"
#include "chart/parts.h"
#include "gonio/base/result.h"
#include "gonio/v1/chart.pb.h"
#include "server/materials/materials.h"

namespace gonio::server {

struct ChartTask {
  std::vector<std::string> parts;
  chart::Options options;
  std::string material;                        // its name; empty: none was given
  std::shared_ptr<const MeasuredTable> table;  // none: the pairs
  v1::MeasuredPairs pairs;
  std::size_t bytes = 0;  // about what the chart holds, the request included
};

// Parses what has come. Errors: as decode_fit_request().
Result<v1::ChartRequest> decode_chart_request(const grpc::ByteBuffer& buffer);

// Cheap: parts and options are checked, the material is looked up. Errors name the field.
Result<ChartTask> chart_task(v1::ChartRequest request, const Materials& materials);

// What is measured; takes the pairs from the task. Errors: arrays whose lengths do not agree.
Result<chart::Wanted> chart_wanted(ChartTask& task);

v1::ChartResult to_wire(std::vector<chart::Table> tables, chart::Machine machine);

}  // namespace gonio::server
