// What Client::fit sends.
#include <algorithm>
#include <string>
#include <utility>

#include "client/messages/fit_convert.h"
#include "wire/words.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

void fill(const FitOptions& from, v1::FitOptions& to) {
  to.set_objective(wire::word_of<v1::FitObjective>(from.objective));
  to.set_strategy(from.strategy == FitStrategy::staged ? v1::FIT_STRATEGY_STAGED
                                                       : v1::FIT_STRATEGY_AUTOMATIC);
  to.set_anisotropic(from.anisotropic);
  to.set_without_cosine(!from.cosine);
  to.set_huber(from.huber);
  to.set_min_theta(from.min_theta);
  to.set_max_theta(from.max_theta);
  to.set_starts(from.starts);
  to.set_fit_pairs(from.fit_pairs);
  to.set_scan_pairs(from.scan_pairs);
  to.set_polish(from.polish);
  to.set_seed(from.seed);
}

}  // namespace

std::optional<Objective> objective_of(std::string_view name) {
  const auto found = std::find(fit::kObjectiveNames.begin(), fit::kObjectiveNames.end(), name);
  if (found == fit::kObjectiveNames.end()) return std::nullopt;
  return static_cast<Objective>(found - fit::kObjectiveNames.begin());
}

Outcome check_size(const FitData& data, std::size_t limit) {
  const std::size_t bytes = data.wi.size_bytes() + data.wo.size_bytes() + data.values.size_bytes() +
                            data.weights.size_bytes();
  if (data.measured || bytes <= limit) return Ok{};
  return bad_value("the size of pairs", std::to_string(bytes) + " bytes",
                   "fewer pairs in one call, of at most " + std::to_string(limit) + " bytes",
                   ErrorCode::resource_exhausted);
}

void fill(const FitData& from, gonio::v1::MeasuredPairs& to) {
  to.mutable_wi()->Assign(from.wi.begin(), from.wi.end());
  to.mutable_wo()->Assign(from.wo.begin(), from.wo.end());
  to.mutable_values()->Assign(from.values.begin(), from.values.end());
  to.mutable_weights()->Assign(from.weights.begin(), from.weights.end());
  to.set_channels(static_cast<std::uint32_t>(std::max(from.channels, 0)));
}

Result<gonio::v1::FitRequest> fit_request(const FitData& data, const Material& form,
                                          const FitOptions& options) {
  if (auto good = check_size(data); !good) return good.error();
  v1::FitRequest request;
  bool readable = request.mutable_form()->ParseFromString(form.wire());
  if (data.measured) {
    readable = readable && request.mutable_measured()->ParseFromString(data.measured->wire());
  } else {
    fill(data, *request.mutable_pairs());
  }
  if (!readable) return bad_value("material", "not readable", "one made by client::Material");
  fill(options, *request.mutable_options());
  return request;
}

}  // namespace gonio::client
