#include "server/messages/chart_request.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "server/materials/measured_pairs.h"
#include "server/messages/decode_request.h"
#include "wire/mapping/chart_table.h"

namespace gonio::server {
namespace {

chart::Options options_of(const v1::ChartRequest& from) {
  chart::Options options;
  // What int cannot hold is out of bounds all the same.
  constexpr std::uint32_t kMost = std::numeric_limits<int>::max();
  set_if_given(options.effort.repetitions, std::min(from.repetitions(), kMost));
  set_if_given(options.effort.seconds, from.seconds());
  set_if_given(options.pairs, from.pairs_at_a_place());
  set_if_given(options.seed, from.seed());
  return options;
}

// The core calls the number of pairs by another name.
Error within_request(Error error) {
  if (error.field != "pairs") return error;
  return bad_value("pairs_at_a_place", error.value, error.allowed);
}

}  // namespace

Result<v1::ChartRequest> decode_chart_request(const grpc::ByteBuffer& buffer) {
  return decode_request<v1::ChartRequest>(buffer, {v1::ChartRequest::kMeasuredFieldNumber});
}

Result<ChartTask> chart_task(v1::ChartRequest request, const Materials& materials) {
  ChartTask task;
  task.parts = {request.parts().begin(), request.parts().end()};
  task.options = options_of(request);
  if (auto good = check(task.parts, task.options); !good) return within_request(good.error());
  task.bytes = chart::memory_of(task.parts, task.options);
  if (request.has_measured()) {
    auto table = table_of(request.measured(), materials);
    if (!table) return table.error();
    task.table = std::move(*table);
    task.material = request.measured().name();
    task.bytes += MeasuredTable::kCells * bytes_of_pair(MeasuredTable::kChannels);
  } else if (request.has_pairs()) {
    if (auto good = check_pairs(request.pairs()); !good) return good.error();
    task.pairs = std::move(*request.mutable_pairs());
    task.material = "measured pairs";
    task.bytes +=
        static_cast<std::size_t>(task.pairs.wi_size()) / 3 * bytes_of_pair(task.pairs.channels());
  }
  return task;
}

Result<chart::Wanted> chart_wanted(ChartTask& task) {
  chart::Wanted wanted{task.parts, std::nullopt};
  if (task.material.empty()) return wanted;
  if (task.table != nullptr) {
    wanted.measured = {task.material, fit::from_table(*task.table), task.table};
    return wanted;
  }
  auto data = data_of(task.pairs);
  if (!data) return data.error();
  task.pairs.Clear();
  wanted.measured = {task.material, std::move(*data), nullptr};
  return wanted;
}

v1::ChartResult to_wire(std::vector<chart::Table> tables, chart::Machine machine) {
  return wire::to_message(chart::Chart{std::move(machine), std::move(tables)});
}

}  // namespace gonio::server
