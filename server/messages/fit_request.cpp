#include "server/messages/fit_request.h"

#include <utility>

#include "engine/material/material_impl.h"
#include "gonio/measured/table.h"
#include "server/materials/build_material.h"
#include "server/materials/measured_pairs.h"
#include "server/messages/decode_request.h"

namespace gonio::server {
namespace {

Result<fit::Objective> objective_of(v1::FitObjective objective) {
  switch (objective) {
    case v1::FIT_OBJECTIVE_UNSPECIFIED:
    case v1::FIT_OBJECTIVE_L1:
      return fit::Objective::l1;
    case v1::FIT_OBJECTIVE_L2:
      return fit::Objective::l2;
    case v1::FIT_OBJECTIVE_HUBER:
      return fit::Objective::huber;
    case v1::FIT_OBJECTIVE_LOG:
      return fit::Objective::log;
    case v1::FIT_OBJECTIVE_CBRT:
      return fit::Objective::cbrt;
    default:
      return bad_value("options.objective", std::to_string(static_cast<int>(objective)),
                       "FIT_OBJECTIVE_L1 (1) to FIT_OBJECTIVE_CBRT (5)");
  }
}

Result<fit::Strategy> strategy_of(v1::FitStrategy strategy) {
  switch (strategy) {
    case v1::FIT_STRATEGY_UNSPECIFIED:
    case v1::FIT_STRATEGY_AUTOMATIC:
      return fit::Strategy::automatic;
    case v1::FIT_STRATEGY_STAGED:
      return fit::Strategy::staged;
    default:
      return bad_value("options.strategy", std::to_string(static_cast<int>(strategy)),
                       "FIT_STRATEGY_AUTOMATIC (1) or FIT_STRATEGY_STAGED (2)");
  }
}

Result<fit::Options> options_of(const v1::FitOptions& from) {
  const auto objective = objective_of(from.objective());
  if (!objective) return objective.error();
  const auto strategy = strategy_of(from.strategy());
  if (!strategy) return strategy.error();
  fit::Options options;
  options.objective = *objective;
  options.strategy = *strategy;
  options.anisotropic = from.anisotropic();
  options.cosine = !from.without_cosine();
  set_if_given(options.huber, from.huber());
  options.min_theta = from.min_theta();
  set_if_given(options.max_theta, from.max_theta());
  set_if_given(options.starts, from.starts());
  set_if_given(options.fit_pairs, from.fit_pairs());
  set_if_given(options.scan_pairs, from.scan_pairs());
  options.polish = from.polish();
  set_if_given(options.seed, from.seed());
  return options;
}

// About what the fit holds; a polish also has the transformed values and a descent's residuals.
std::size_t bytes_of(std::size_t pairs, std::size_t channels, bool polish) {
  constexpr std::size_t kSubsets = std::size_t{32} << 20;
  return kSubsets + pairs * (bytes_of_pair(channels) + (polish ? 48 * channels : 0));
}

}  // namespace

Result<v1::FitRequest> decode_fit_request(const grpc::ByteBuffer& buffer) {
  return decode_request<v1::FitRequest>(
      buffer, {v1::FitRequest::kMeasuredFieldNumber, v1::FitRequest::kFormFieldNumber});
}

Result<FitTask> fit_task(const v1::FitRequest& request, const Materials& materials) {
  auto form = material_spec(request.form(), "form.");
  if (!form) return form.error();
  auto options = options_of(request.options());
  if (!options) return options.error();
  FitTask task{std::move(*form), *options, nullptr, 0};
  if (request.has_measured()) {
    auto table = table_of(request.measured(), materials);
    if (!table) return table.error();
    task.table = std::move(*table);
    task.bytes = bytes_of(MeasuredTable::kCells, MeasuredTable::kChannels, options->polish);
    return task;
  }
  if (!request.has_pairs()) return bad_value("data", "not given", "pairs or measured");
  if (auto good = check_pairs(request.pairs()); !good) return good.error();
  task.bytes = bytes_of(static_cast<std::size_t>(request.pairs().wi_size()) / 3,
                        request.pairs().channels(), options->polish);
  return task;
}

Result<fit::Data> fit_data(const v1::FitRequest& request, const FitTask& task) {
  if (task.table) return fit::from_table(*task.table);
  return data_of(request.pairs());
}

}  // namespace gonio::server
