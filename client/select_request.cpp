// What Client::select sends.
#include <array>
#include <string>
#include <utility>

#include "client/fit_convert.h"
#include "client/select_convert.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

constexpr std::array<std::string_view, 5> kMetrics{"l1", "rmse", "log", "cbrt", "delta_e"};
constexpr std::array<std::string_view, 3> kCosts{"ns", "bytes", "ns_variance"};
constexpr std::array<std::string_view, 2> kLights{"directional", "environment"};

template <class Enum, std::size_t N>
Result<Enum> named(const std::array<std::string_view, N>& names, const char* field,
                   std::string_view name) {
  std::string known;
  for (std::size_t i = 0; i < N; ++i) {
    if (names[i] == name) return static_cast<Enum>(i);
    known += (known.empty() ? "" : ", ") + std::string(names[i]);
  }
  return bad_value(field, '"' + std::string(name) + '"', known);
}

// The wire's words are these in the same order, after one for the default.
template <class To, class From>
To word(From from) {
  return static_cast<To>(static_cast<int>(from) + 1);
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
  to.set_lights(word<v1::SelectLights>(from.lights));
  to.set_isotropic(!from.anisotropy);
  to.set_metric(word<v1::SelectMetric>(from.metric));
  to.set_tolerance(from.tolerance);
  to.set_confidence(from.confidence);
  to.set_cost(word<v1::SelectCost>(from.cost));
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
  v1::SelectRequest request;
  const bool readable =
      std::visit([&](const auto& given) { return fill(given, request); }, reference);
  if (!readable) return bad_value("material", "not readable", "one made by client::Material");
  fill(scene, *request.mutable_scene());
  fill(options, *request.mutable_options());
  return request;
}

}  // namespace gonio::client
