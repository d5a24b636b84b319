#include "client/cli/scene_file.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <numbers>
#include <optional>
#include <vector>

namespace gonio::cli {
namespace {

using google::protobuf::Struct;
using google::protobuf::Value;

constexpr double kRadians = std::numbers::pi / 180;
constexpr std::array<std::string_view, 10> kFields{
    "theta_i",    "theta_o", "phi",       "histogram",  "lights",
    "anisotropy", "metric",  "tolerance", "confidence", "cost"};
constexpr std::array<std::string_view, 4> kHistogram{"theta_i", "theta_o", "phi", "counts"};

Result<Struct> read_object(const std::string& file, const char* what) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return bad_value(what, file, "a JSON file that can be read", ErrorCode::not_found);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Struct object;
  const auto status = google::protobuf::util::JsonStringToMessage(text, &object);
  if (status.ok()) return object;
  return Error{ErrorCode::invalid_argument, file + ": " + std::string(status.message()), what, file,
               "a JSON object"};
}

std::string as_text(const Value& value) {
  std::string text;
  (void)google::protobuf::util::MessageToJsonString(value, &text);
  return text;
}

template <std::size_t N>
Outcome check_names(const Struct& object, const std::array<std::string_view, N>& known,
                    const std::string& prefix) {
  std::string all;
  for (const std::string_view name : known) all += (all.empty() ? "" : ", ") + std::string(name);
  for (const auto& [name, value] : object.fields()) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return bad_value(prefix + name, "not a field", all);
  }
  return Ok{};
}

const Value* find(const Struct& object, const char* name) {
  const auto found = object.fields().find(name);
  return found == object.fields().end() ? nullptr : &found->second;
}

// Numbers, each times `unit`.
Result<std::vector<double>> numbers(const Value& value, const std::string& field, double unit) {
  std::vector<double> all;
  for (const Value& number : value.list_value().values()) {
    if (!number.has_number_value()) return bad_value(field, as_text(number), "numbers");
    all.push_back(number.number_value() * unit);
  }
  if (!value.has_list_value()) return bad_value(field, as_text(value), "a list of numbers");
  return all;
}

// [lower, upper] in degrees; `usual` where it is not given, if there is one.
Result<select::Range> range(const Struct& object, const char* name,
                            std::optional<select::Range> usual) {
  const std::string field = std::string("scene.") + name;
  const Value* value = find(object, name);
  if (value == nullptr) {
    if (usual) return *usual;
    return bad_value(field, "not given", "[lower, upper] in degrees");
  }
  const auto ends = numbers(*value, field, kRadians);
  if (!ends) return ends.error();
  if (ends->size() != 2)
    return bad_value(field, as_text(*value), "two numbers: [lower, upper] in degrees");
  return select::Range{(*ends)[0], (*ends)[1]};
}

Result<std::vector<select::Bin>> histogram(const Value& value) {
  const Struct& object = value.struct_value();
  if (!value.has_struct_value())
    return bad_value("scene.histogram", as_text(value),
                     "an object of theta_i, theta_o, phi and counts");
  if (auto ok = check_names(object, kHistogram, "scene.histogram."); !ok) return ok.error();
  std::array<std::vector<double>, 4> lists;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const std::string name(kHistogram[i]);
    const Value* list = find(object, name.c_str());
    if (list == nullptr)
      return bad_value("scene.histogram." + name, "not given", "a list of numbers");
    auto read = numbers(*list, "scene.histogram." + name, name == "counts" ? 1 : kRadians);
    if (!read) return read.error();
    lists[i] = std::move(*read);
  }
  return select::bins_of(lists[0], lists[1], lists[2], lists[3]);
}

Result<std::vector<select::Bin>> ranges(const Struct& object, select::Lights lights) {
  if (!find(object, "theta_i") && !find(object, "theta_o") && !find(object, "phi"))
    return std::vector<select::Bin>{};  // check() says that this is no scene
  std::optional<select::Range> everywhere;
  if (lights == select::Lights::environment) everywhere = select::Range{0, 90 * kRadians};
  const auto theta_i = range(object, "theta_i", everywhere),
             theta_o = range(object, "theta_o", std::nullopt),
             phi = range(object, "phi", select::Range{0, 180 * kRadians});
  for (const auto* found : {&theta_i, &theta_o, &phi}) {
    if (!*found) return found->error();
  }
  return std::vector<select::Bin>{{*theta_i, *theta_o, *phi}};
}

Result<std::vector<select::Bin>> bins(const Struct& object, select::Lights lights) {
  const Value* logged = find(object, "histogram");
  if (logged == nullptr) return ranges(object, lights);
  for (const char* name : {"theta_i", "theta_o", "phi"}) {
    if (find(object, name) != nullptr)
      return bad_value("scene.histogram", std::string("beside ") + name, "ranges or a histogram");
  }
  return histogram(*logged);
}

Outcome read_number(const Struct& object, const char* name, double& to) {
  const Value* value = find(object, name);
  if (value == nullptr) return Ok{};
  if (!value->has_number_value())
    return bad_value(std::string("scene.") + name, as_text(*value), "a number");
  to = value->number_value();
  return Ok{};
}

// A word by the function that knows the words.
template <class Enum, class OfName>
Outcome read_word(const Struct& object, const char* name, const OfName& of_name, Enum& to) {
  const Value* value = find(object, name);
  if (value == nullptr) return Ok{};
  auto found = of_name(value->has_string_value() ? value->string_value() : as_text(*value));
  if (!found) return found.error();
  to = *found;
  return Ok{};
}

Outcome read_switch(const Struct& object, const char* name, bool& to) {
  const Value* value = find(object, name);
  if (value == nullptr) return Ok{};
  if (!value->has_bool_value())
    return bad_value(std::string("scene.") + name, as_text(*value), "true or false");
  to = value->bool_value();
  return Ok{};
}

}  // namespace

Result<select::Scene> read_scene(const std::string& file) {
  const auto object = read_object(file, "scene");
  if (!object) return object.error();
  if (auto ok = check_names(*object, kFields, "scene."); !ok) return ok.error();
  select::Scene scene;
  for (const Outcome& ok : {read_word(*object, "lights", select::lights_of, scene.lights),
                            read_word(*object, "metric", select::metric_of, scene.metric),
                            read_word(*object, "cost", select::cost_of, scene.cost),
                            read_number(*object, "tolerance", scene.tolerance),
                            read_number(*object, "confidence", scene.confidence),
                            read_switch(*object, "anisotropy", scene.anisotropy)}) {
    if (!ok) return ok.error();
  }
  auto found = bins(*object, scene.lights);
  if (!found) return found.error();
  scene.bins = std::move(*found);
  if (auto ok = check(scene); !ok) return ok.error();
  return scene;
}

Result<select::CostTable> read_costs(const std::string& file) {
  const auto object = read_object(file, "costs");
  if (!object) return object.error();
  select::CostTable costs;
  for (const auto& [part, value] : object->fields()) {
    if (!value.has_number_value() || !(value.number_value() > 0))
      return bad_value("costs." + part, as_text(value), "a number above 0, in nanoseconds");
    costs[part] = value.number_value();
  }
  if (costs.empty()) return bad_value("costs", "empty", "a number for every part");
  return costs;
}

}  // namespace gonio::cli
