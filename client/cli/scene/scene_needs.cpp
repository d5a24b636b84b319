#include "client/cli/scene/scene_needs.h"

#include <array>
#include <numbers>
#include <optional>
#include <utility>

#include "client/cli/scene/json_fields.h"
#include "select/scene.h"

namespace gonio::cli {
namespace {

using client::SelectBin;
using client::SelectLights;
using client::SelectRange;
using client::SelectScene;

constexpr double kRadians = std::numbers::pi / 180;
constexpr std::array<std::string_view, 4> kHistogram{"theta_i", "theta_o", "phi", "counts"};
const std::string kPrefix = "scene.";

// [lower, upper] in degrees; `usual` where it is not given, if there is one.
Result<SelectRange> range(const JsonObject& object, const char* name,
                          std::optional<SelectRange> usual) {
  const std::string field = kPrefix + name;
  const JsonValue* value = find(object, name);
  if (value == nullptr) {
    if (usual) return *usual;
    return bad_value(field, "not given", "[lower, upper] in degrees");
  }
  const auto ends = numbers(*value, field, kRadians);
  if (!ends) return ends.error();
  if (ends->size() != 2)
    return bad_value(field, as_text(*value), "two numbers: [lower, upper] in degrees");
  return SelectRange{(*ends)[0], (*ends)[1]};
}

SelectBin bin_of(const select::Bin& from) {
  const auto range = [](const select::Range& of) { return SelectRange{of.lower, of.upper}; };
  return {range(from.theta_i), range(from.theta_o), range(from.phi), from.weight};
}

Result<std::vector<SelectBin>> histogram(const JsonValue& value) {
  const std::string prefix = kPrefix + "histogram.";
  if (!value.has_struct_value())
    return bad_value(kPrefix + "histogram", as_text(value),
                     "an object of theta_i, theta_o, phi and counts");
  const JsonObject& object = value.struct_value();
  if (auto ok = check_names(object, kHistogram, prefix); !ok) return ok.error();
  std::array<std::vector<double>, 4> lists;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string name(kHistogram[i]);
    const JsonValue* list = find(object, name);
    if (list == nullptr) return bad_value(prefix + name, "not given", "a list of numbers");
    auto read = numbers(*list, prefix + name, name == "counts" ? 1 : kRadians);
    if (!read) return read.error();
    lists[i] = std::move(*read);
  }
  const auto logged = select::bins_of(lists[0], lists[1], lists[2], lists[3]);
  if (!logged) return logged.error();
  std::vector<SelectBin> bins;
  for (const select::Bin& bin : *logged) bins.push_back(bin_of(bin));
  return bins;
}

Result<std::vector<SelectBin>> ranges(const JsonObject& object, SelectLights lights) {
  if (!find(object, "theta_i") && !find(object, "theta_o") && !find(object, "phi"))
    return std::vector<SelectBin>{};  // the service says that this is no scene
  std::optional<SelectRange> everywhere;
  if (lights == SelectLights::environment) everywhere = SelectRange{0, 90 * kRadians};
  const auto theta_i = range(object, "theta_i", everywhere),
             theta_o = range(object, "theta_o", std::nullopt),
             phi = range(object, "phi", SelectRange{0, 180 * kRadians});
  for (const auto* found : {&theta_i, &theta_o, &phi}) {
    if (!*found) return found->error();
  }
  return std::vector<SelectBin>{{*theta_i, *theta_o, *phi}};
}

Result<std::vector<SelectBin>> bins(const JsonObject& object, SelectLights lights) {
  const JsonValue* logged = find(object, "histogram");
  if (logged == nullptr) return ranges(object, lights);
  for (const std::string_view name : kRangeFields) {
    if (find(object, std::string(name)) != nullptr)
      return bad_value(kPrefix + "histogram", "beside " + std::string(name),
                       "ranges or a histogram");
  }
  return histogram(*logged);
}

// A word by the function that knows the words.
template <class Enum, class OfName>
Outcome read_word(const JsonObject& object, const char* name, const OfName& of_name, Enum& to) {
  const JsonValue* value = find(object, name);
  if (value == nullptr) return Ok{};
  auto found = of_name(value->has_string_value() ? value->string_value() : as_text(*value));
  if (!found) return found.error();
  to = *found;
  return Ok{};
}

// Whether time matters. No model varies with it: a scene that needs one is told so.
Outcome check_time(const JsonObject& object) {
  bool matters = false;
  if (auto ok = read_switch(object, "time", kPrefix, matters); !ok) return ok;
  if (!matters) return Ok{};
  return bad_value(kPrefix + "time", "true", "false: no material here varies with time");
}

}  // namespace

Result<client::SelectScene> scene_needs(const JsonObject& object) {
  SelectScene scene;
  for (const Outcome& ok :
       {read_word(object, "lights", client::lights_of, scene.lights),
        read_word(object, "metric", client::metric_of, scene.metric),
        read_word(object, "cost", client::cost_of, scene.cost),
        read_number(object, "tolerance", kPrefix, scene.tolerance),
        read_number(object, "confidence", kPrefix, scene.confidence),
        read_switch(object, "anisotropy", kPrefix, scene.anisotropy), check_time(object)}) {
    if (!ok) return ok.error();
  }
  auto found = bins(object, scene.lights);
  if (!found) return found.error();
  scene.bins = std::move(*found);
  if (!scene.bins.empty() && find(object, "tolerance") == nullptr)
    return bad_value(kPrefix + "tolerance", "not given", "a number above 0, of the metric");
  return scene;
}

}  // namespace gonio::cli
