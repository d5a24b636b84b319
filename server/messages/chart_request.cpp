#include "server/messages/chart_request.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "server/materials/measured_pairs.h"
#include "server/messages/decode_request.h"

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

v1::ChartTable table_to_wire(const chart::Table& from) {
  v1::ChartTable to;
  to.set_name(from.name);
  to.set_title(from.title);
  for (const chart::Column& column : from.columns) {
    v1::ChartColumn& added = *to.add_columns();
    added.set_name(column.name);
    added.set_unit(column.unit);
    added.set_meaning(column.meaning);
  }
  for (const auto& row : from.rows) {
    v1::ChartRow& added = *to.add_rows();
    for (const chart::Cell& cell : row) {
      if (const auto* word = std::get_if<std::string>(&cell)) {
        added.add_cells()->set_word(*word);
      } else {
        added.add_cells()->set_number(std::get<double>(cell));
      }
    }
  }
  return to;
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

v1::ChartResult to_wire(const std::vector<chart::Table>& tables, const chart::Machine& machine) {
  v1::ChartResult result;
  v1::ChartMachine& to = *result.mutable_machine();
  to.set_processor(machine.processor);
  to.set_cores(machine.cores);
  for (const std::string& set : machine.instruction_sets) to.add_instruction_sets(set);
  to.set_gonio(machine.gonio);
  to.set_compiler(machine.compiler);
  to.set_system(machine.system);
  for (const chart::Table& table : tables) *result.add_tables() = table_to_wire(table);
  return result;
}

}  // namespace gonio::server
