#include <algorithm>
#include <optional>
#include <utility>

#include "client/calls/state.h"
#include "client/messages/chart_request.h"
#include "client/rpc/progress_call.h"
#include "client/transfer/check_answer.h"
#include "gonio/client/client.h"
#include "gonio/v1/chart.pb.h"
#include "wire/mapping/chart_table.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

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
  const auto request = chart_request(options);
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
