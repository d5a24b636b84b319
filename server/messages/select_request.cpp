#include "server/messages/select_request.h"

#include <algorithm>
#include <string>
#include <utility>

#include "server/materials/measured_pairs.h"
#include "server/messages/decode_request.h"
#include "wire/message.h"
#include "wire/words.h"

namespace gonio::server {
namespace {

static_assert(wire::same_words<select::Metric, v1::SelectMetric>(
    {{select::Metric::l1, v1::SELECT_METRIC_L1},
     {select::Metric::rmse, v1::SELECT_METRIC_RMSE},
     {select::Metric::log, v1::SELECT_METRIC_LOG},
     {select::Metric::cbrt, v1::SELECT_METRIC_CBRT},
     {select::Metric::delta_e, v1::SELECT_METRIC_DELTA_E}},
    v1::SelectMetric_MAX));
static_assert(wire::same_words<select::CostKind, v1::SelectCost>(
    {{select::CostKind::ns, v1::SELECT_COST_NS},
     {select::CostKind::bytes, v1::SELECT_COST_BYTES},
     {select::CostKind::ns_variance, v1::SELECT_COST_NS_VARIANCE}},
    v1::SelectCost_MAX));
static_assert(wire::same_words<select::Lights, v1::SelectLights>(
    {{select::Lights::directional, v1::SELECT_LIGHTS_DIRECTIONAL},
     {select::Lights::environment, v1::SELECT_LIGHTS_ENVIRONMENT}},
    v1::SelectLights_MAX));

template <class To, class From>
Result<To> word(From from, int last, To usual, const char* field, const char* allowed) {
  const int number = static_cast<int>(from);
  if (number == 0) return usual;
  if (number > 0 && number <= last) return static_cast<To>(number - 1);
  return bad_value(field, std::to_string(number), allowed);
}

select::Range range_of(const v1::SelectRange& from) { return {from.lower(), from.upper()}; }

select::Bin bin_of(const v1::SelectBin& from) {
  select::Bin to;
  to.theta_i = range_of(from.theta_i());
  to.theta_o = range_of(from.theta_o());
  if (from.has_phi()) to.phi = range_of(from.phi());
  if (from.has_weight()) to.weight = from.weight();
  return to;
}

Result<select::Scene> scene_of(const v1::SelectScene& from) {
  const auto metric = word(from.metric(), v1::SelectMetric_MAX, select::Metric::l1, "scene.metric",
                           "SELECT_METRIC_L1 (1) to SELECT_METRIC_DELTA_E (5)");
  if (!metric) return metric.error();
  const auto cost = word(from.cost(), v1::SelectCost_MAX, select::CostKind::ns, "scene.cost",
                         "SELECT_COST_NS (1) to SELECT_COST_NS_VARIANCE (3)");
  if (!cost) return cost.error();
  const auto lights =
      word(from.lights(), v1::SelectLights_MAX, select::Lights::directional, "scene.lights",
           "SELECT_LIGHTS_DIRECTIONAL (1) or SELECT_LIGHTS_ENVIRONMENT (2)");
  if (!lights) return lights.error();
  select::Scene scene;
  for (const auto& bin : from.bins()) scene.bins.push_back(bin_of(bin));
  scene.lights = *lights;
  scene.anisotropy = !from.isotropic();
  scene.metric = *metric;
  scene.tolerance = from.tolerance();
  if (from.has_confidence()) scene.confidence = from.confidence();
  scene.cost = *cost;
  if (auto good = check(scene); !good) return good.error();
  return scene;
}

Result<select::Options> options_of(const v1::SelectOptions& from) {
  select::Options options;
  options.whole_front = !from.up_to_the_choice();
  // What int cannot hold is out of bounds all the same.
  set_if_given(options.lobes, std::min<std::uint32_t>(from.lobes(), 1000));
  options.costs = {from.costs().begin(), from.costs().end()};
  set_if_given(options.sizes.fitted, from.fitted());
  set_if_given(options.sizes.validation, from.validation());
  set_if_given(options.sizes.certification, from.certification());
  set_if_given(options.starts, from.starts());
  set_if_given(options.seed, from.seed());
  if (auto good = check(options); !good) return good.error();
  return options;
}

}  // namespace

Result<v1::SelectRequest> decode_select_request(const grpc::ByteBuffer& buffer) {
  return decode_request<v1::SelectRequest>(buffer, {v1::SelectRequest::kMaterialFieldNumber});
}

Result<SelectTask> select_task(v1::SelectRequest request, const Materials& materials) {
  auto scene = scene_of(request.scene());
  if (!scene) return scene.error();
  auto options = options_of(request.options());
  if (!options) return options.error();
  SelectTask task{std::move(*scene), std::move(*options), std::nullopt, {}, 0};
  if (request.has_material()) {
    auto material = materials.resolve(wire::to_bytes(request.material()));
    if (!material) return material.error();
    task.material = std::move(*material);
    task.bytes = memory_of(task.material->material().channels(), task.scene, task.options);
    return task;
  }
  if (!request.has_pairs()) return bad_value("reference", "not given", "a material or pairs");
  if (auto good = check_pairs(request.pairs()); !good) return good.error();
  task.pairs = std::move(*request.mutable_pairs());
  const std::size_t channels = task.pairs.channels();
  task.bytes = memory_of(static_cast<int>(channels), task.scene, task.options) +
               static_cast<std::size_t>(task.pairs.wi_size()) / 3 * bytes_of_pair(channels);
  return task;
}

Result<fit::Data> select_data(SelectTask& task) {
  auto data = data_of(task.pairs);
  task.pairs.Clear();
  return data;
}

}  // namespace gonio::server
