#include "client/messages/chart_request.h"

#include <string>

#include "client/messages/fit_convert.h"

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

}  // namespace

Result<v1::ChartRequest> chart_request(const ChartOptions& options) {
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

}  // namespace gonio::client
