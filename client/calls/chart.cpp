#include "wire/mapping/chart.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "client/messages/fit_convert.h"
#include "client/rpc/check_answer.h"
#include "client/rpc/progress_call.h"
#include "client/rpc/state.h"
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

// Names become names of files.
bool is_plain(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

// Errors: a name that is none, a row that is not as wide as its table, or has a word for a number.
Outcome check(const ChartTable& table, const Peer& peer) {
  if (!is_plain(table.name)) return malformed(peer, "a table's name is not of letters and digits");
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size())
      return malformed(peer, "a table's row is not as wide as its columns");
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (std::holds_alternative<std::string>(row[i]) != table.columns[i].unit.empty())
        return malformed(peer, "a table has a word for a number, or a number for a word");
    }
  }
  return Ok{};
}

Result<Chart> chart_of(const v1::ChartResult& from, const Peer& peer) {
  auto chart = wire::from_message<Chart>(from);
  if (!chart) return chart.error();
  for (const ChartTable& table : chart->tables) {
    if (auto good = check(table, peer); !good) return good.error();
  }
  return chart;
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
      watch.progress(wire::from_message<ChartProgress>(response.progress()).value());
    return result.has_value();
  };
  Patience patience(state_->options, options.deadline);
  const auto done = call_with_progress(state_->peer, {kChartMethod, "the chart"},
                                       wire::to_buffer(*request), patience, watch.stop, take);
  if (!done) return done.error();
  return chart_of(*result, state_->peer);
}

}  // namespace gonio::client
