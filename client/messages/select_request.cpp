// What Client::select sends.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "base/near_names.h"
#include "client/messages/fit_convert.h"
#include "client/messages/select_convert.h"
#include "wire/words.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

// In the order of the enums, which are cast to and from the wire's.
constexpr std::array<std::string_view, v1::SelectMetric_MAX> kMetrics{"l1", "rmse", "log", "cbrt",
                                                                      "delta_e"};
constexpr std::array<std::string_view, v1::SelectCost_MAX> kCosts{"ns", "bytes", "ns_variance"};
constexpr std::array<std::string_view, v1::SelectLights_MAX> kLights{"directional", "environment"};
static_assert(wire::same_words<SelectMetric, v1::SelectMetric>(
    {{SelectMetric::l1, v1::SELECT_METRIC_L1},
     {SelectMetric::rmse, v1::SELECT_METRIC_RMSE},
     {SelectMetric::log, v1::SELECT_METRIC_LOG},
     {SelectMetric::cbrt, v1::SELECT_METRIC_CBRT},
     {SelectMetric::delta_e, v1::SELECT_METRIC_DELTA_E}},
    v1::SelectMetric_MAX));
static_assert(wire::same_words<SelectCost, v1::SelectCost>(
    {{SelectCost::ns, v1::SELECT_COST_NS},
     {SelectCost::bytes, v1::SELECT_COST_BYTES},
     {SelectCost::ns_variance, v1::SELECT_COST_NS_VARIANCE}},
    v1::SelectCost_MAX));
static_assert(wire::same_words<SelectLights, v1::SelectLights>(
    {{SelectLights::directional, v1::SELECT_LIGHTS_DIRECTIONAL},
     {SelectLights::environment, v1::SELECT_LIGHTS_ENVIRONMENT}},
    v1::SelectLights_MAX));

template <class Enum, std::size_t N>
Result<Enum> named(const std::array<std::string_view, N>& names, const char* field,
                   std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Enum>(found - names.begin());
  return unknown_word(field, name, std::span<const std::string_view>(names));
}

void fill(const SelectRange& from, v1::SelectRange& to) {
  to.set_lower(from.lower);
  to.set_upper(from.upper);
}

void fill(const SelectScene& from, v1::SelectScene& to) {
  for (const SelectBin& bin : from.bins) {
    v1::SelectBin& sent = *to.add_bins();
    fill(bin.theta_i, *sent.mutable_theta_i());
    fill(bin.theta_o, *sent.mutable_theta_o());
    fill(bin.phi, *sent.mutable_phi());
    sent.set_weight(bin.weight);
  }
  to.set_lights(wire::word_of<v1::SelectLights>(from.lights));
  to.set_isotropic(!from.anisotropy);
  to.set_metric(wire::word_of<v1::SelectMetric>(from.metric));
  to.set_tolerance(from.tolerance);
  to.set_confidence(from.confidence);
  to.set_cost(wire::word_of<v1::SelectCost>(from.cost));
}

// 0 would mean the default on the wire.
Outcome check(const SelectOptions& options) {
  const std::array<std::pair<const char*, std::uint64_t>, 6> numbers{
      {{"options.lobes", options.lobes},
       {"options.fitted", options.fitted},
       {"options.validation", options.validation},
       {"options.certification", options.certification},
       {"options.starts", options.starts},
       {"options.seed", options.seed}}};
  for (const auto& [field, number] : numbers) {
    if (number == 0) return bad_value(field, "0", "1 or more");
  }
  return Ok{};
}

void fill(const SelectOptions& from, v1::SelectOptions& to) {
  to.set_up_to_the_choice(!from.whole_front);
  to.set_lobes(from.lobes);
  for (const auto& [part, ns] : from.costs) (*to.mutable_costs())[part] = ns;
  to.set_fitted(from.fitted);
  to.set_validation(from.validation);
  to.set_certification(from.certification);
  to.set_starts(from.starts);
  to.set_seed(from.seed);
}

// Measured materials of the server's are materials here.
bool fill(const FitData& from, v1::SelectRequest& to) {
  if (from.measured) return to.mutable_material()->ParseFromString(from.measured->wire());
  fill(from, *to.mutable_pairs());
  return true;
}

bool fill(const Material& from, v1::SelectRequest& to) {
  return to.mutable_material()->ParseFromString(from.wire());
}

}  // namespace

Result<SelectMetric> metric_of(std::string_view name) {
  return named<SelectMetric>(kMetrics, "scene.metric", name);
}
Result<SelectCost> cost_of(std::string_view name) {
  return named<SelectCost>(kCosts, "scene.cost", name);
}
Result<SelectLights> lights_of(std::string_view name) {
  return named<SelectLights>(kLights, "scene.lights", name);
}

Result<v1::SelectRequest> select_request(const SelectReference& reference, const SelectScene& scene,
                                         const SelectOptions& options) {
  if (auto good = check(options); !good) return good.error();
  if (const auto* data = std::get_if<FitData>(&reference)) {
    if (auto good = check_size(*data); !good) return good.error();
  }
  v1::SelectRequest request;
  const bool readable =
      std::visit([&](const auto& given) { return fill(given, request); }, reference);
  if (!readable) return bad_value("material", "not readable", "one made by client::Material");
  fill(scene, *request.mutable_scene());
  fill(options, *request.mutable_options());
  return request;
}

}  // namespace gonio::client
