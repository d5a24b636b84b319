#include <algorithm>
#include <optional>
#include <utility>

#include "client/calls/state.h"
#include "client/messages/fit_convert.h"
#include "client/rpc/progress_call.h"
#include "client/transfer/check_answer.h"
#include "gonio/client/client.h"
#include "gonio/v1/chart.pb.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

// 0 would mean the default on the wire.
Outcome check(const ChartOptions& options) {
  if (options.repetitions == 0) return bad_value("repetitions", "0", "1 to 1000");
  if (options.seconds == 0) return bad_value("seconds", "0", "1e-6 to 0.1");
  if (options.pairs_at_a_place == 0) return bad_value("pairs_at_a_place", "0", "1 to 20000");
  if (options.seed == 0) return bad_value("seed", "0", "1 or more");
  return Ok{};
}

Result<v1::ChartRequest> request_of(const ChartOptions& options) {
  if (auto good = check(options); !good) return good.error();
  v1::ChartRequest request;
  for (const std::string& part : options.parts) request.add_parts(part);
  request.set_repetitions(options.repetitions);
  request.set_seconds(options.seconds);
  request.set_pairs_at_a_place(options.pairs_at_a_place);
  request.set_seed(options.seed);
  if (!options.data) return request;
  if (auto good = check_size(*options.data); !good) return good.error();
  if (!options.data->measured) {
    fill(*options.data, *request.mutable_pairs());
  } else if (!request.mutable_measured()->ParseFromString(options.data->measured->wire())) {
    return bad_value("data.measured", "not readable", "a material made by client::Material");
  }
  return request;
}

ChartMachine machine_of(const v1::ChartMachine& from) {
  return {from.processor(),
          from.cores(),
          {from.instruction_sets().begin(), from.instruction_sets().end()},
          from.gonio(),
          from.compiler(),
          from.system()};
}

ChartCell cell_of(const v1::ChartCell& from) {
  if (from.value_case() == v1::ChartCell::kWord) return from.word();
  return from.number();
}

// Names become names of files.
bool is_plain(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

// Errors: a name that is none, a row that is not as wide as its table, or has a word for a number.
Result<ChartTable> table_of(const v1::ChartTable& from, const Peer& peer) {
  ChartTable to{from.name(), from.title(), {}, {}};
  if (!is_plain(to.name)) return malformed(peer, "a table's name is not of letters and digits");
  for (const auto& column : from.columns())
    to.columns.push_back({column.name(), column.unit(), column.meaning()});
  for (const auto& row : from.rows()) {
    if (row.cells_size() != from.columns_size())
      return malformed(peer, "a table's row is not as wide as its columns");
    std::vector<ChartCell> cells;
    for (const auto& cell : row.cells()) {
      const bool word = cell.value_case() == v1::ChartCell::kWord;
      if (word != to.columns[cells.size()].unit.empty())
        return malformed(peer, "a table has a word for a number, or a number for a word");
      cells.push_back(cell_of(cell));
    }
    to.rows.push_back(std::move(cells));
  }
  return to;
}

Result<Chart> chart_of(const v1::ChartResult& from, const Peer& peer) {
  Chart to{machine_of(from.machine()), {}};
  for (const auto& table : from.tables()) {
    auto converted = table_of(table, peer);
    if (!converted) return converted.error();
    to.tables.push_back(std::move(*converted));
  }
  return to;
}

}  // namespace

Result<Chart> Client::chart(const ChartOptions& options, const ChartWatch& watch) const {
  const auto request = request_of(options);
  if (!request) return request.error();
  std::optional<v1::ChartResult> result;
  const auto take = [&](grpc::ByteBuffer& bytes) {
    v1::ChartResponse response;
    if (!wire::from_buffer(bytes, response)) return false;
    if (response.has_result()) result = std::move(*response.mutable_result());
    if (response.has_progress() && watch.progress)
      watch.progress({response.progress().stage(), response.progress().done()});
    return result.has_value();
  };
  Patience patience(state_->options, options.deadline);
  const auto done = call_with_progress(state_->peer, {kChartMethod, "the chart"},
                                       wire::to_buffer(*request), patience, watch.stop, take);
  if (!done) return done.error();
  return chart_of(*result, state_->peer);
}

}  // namespace gonio::client
