// What Client::fit sends.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "client/messages/fit_convert.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

constexpr std::array<std::pair<Objective, std::string_view>, 5> kObjectives{
    {{Objective::l1, "l1"},
     {Objective::l2, "l2"},
     {Objective::huber, "huber"},
     {Objective::log, "log"},
     {Objective::cbrt, "cbrt"}}};

v1::FitObjective to_wire(Objective objective) {
  switch (objective) {
    case Objective::l1:
      return v1::FIT_OBJECTIVE_L1;
    case Objective::l2:
      return v1::FIT_OBJECTIVE_L2;
    case Objective::huber:
      return v1::FIT_OBJECTIVE_HUBER;
    case Objective::log:
      return v1::FIT_OBJECTIVE_LOG;
    case Objective::cbrt:
      return v1::FIT_OBJECTIVE_CBRT;
  }
  return v1::FIT_OBJECTIVE_UNSPECIFIED;
}

void fill(const FitOptions& from, v1::FitOptions& to) {
  to.set_objective(to_wire(from.objective));
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

std::string_view name_of(Objective objective) {
  return std::find_if(kObjectives.begin(), kObjectives.end(),
                      [&](const auto& known) { return known.first == objective; })
      ->second;
}

std::optional<Objective> objective_of(std::string_view name) {
  for (const auto& [objective, known] : kObjectives) {
    if (known == name) return objective;
  }
  return std::nullopt;
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
