#include "client/cli/scene/scene_file.h"

#include <filesystem>
#include <utility>

#include "client/cli/output/json.h"
#include "client/cli/scene/json_fields.h"
#include "client/cli/scene/scene_needs.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

const std::string kPrefix = "scene.";

// Those of needs and one more.
Outcome check_fields(const JsonObject& object, std::string_view more, const std::string& prefix) {
  std::vector<std::string_view> known(kNeedFields.begin(), kNeedFields.end());
  known.push_back(more);
  return check_names(object, known, prefix);
}

// What is said of all materials with what one says itself in its place: ranges, or a histogram.
JsonObject merged(const JsonObject& of_all, const JsonObject& own) {
  JsonObject both = of_all;
  auto& fields = *both.mutable_fields();
  if (find(own, "histogram") != nullptr) {
    for (const std::string_view name : kRangeFields) fields.erase(std::string(name));
  }
  for (const std::string_view name : kRangeFields) {
    if (find(own, std::string(name)) != nullptr) fields.erase("histogram");
  }
  for (const auto& [name, value] : own.fields()) fields[name] = value;
  return both;
}

// A name is that of a file in the folder of choices.
Outcome check_name(const std::string& name) {
  constexpr std::size_t kLongest = 200;  // of 255, for ".json" and what it is called until complete
  const bool one = !name.empty() && name != "." && name != ".." && name.size() <= kLongest &&
                   name.find('/') == std::string::npos && name.find('\0') == std::string::npos;
  if (one) return Ok{};
  return bad_value("scene.materials", json_string(name) + " as a name",
                   "names of files: 1 to 200 bytes, no / in them, not . or ..");
}

// A file's place is relative to the scene's; JSON stays JSON, and a name a name.
Result<std::string> reference_of(const JsonObject& material, const std::string& scene_file) {
  const JsonValue* value = find(material, "reference");
  if (value == nullptr)
    return bad_value("reference", "not given", "a file, a material or the name of one");
  if (value->has_struct_value()) return as_text(*value);
  if (!value->has_string_value())
    return bad_value("reference", as_text(*value), "a file, a material or the name of one");
  const std::filesystem::path path = value->string_value();
  if (!path.has_extension() && !path.has_parent_path()) return path.string();
  return (std::filesystem::path(scene_file).parent_path() / path).string();
}

Result<SceneMaterial> material_of(const std::string& name, const JsonValue& value,
                                  const JsonObject& of_all, const std::string& file) {
  if (!value.has_struct_value())
    return bad_value("material", as_text(value), "an object with a reference");
  const JsonObject& own = value.struct_value();
  if (auto ok = check_fields(own, "reference", {}); !ok) return ok.error();
  auto reference = reference_of(own, file);
  if (!reference) return reference.error();
  auto needs = scene_needs(merged(of_all, own));
  if (!needs) return needs.error();
  return SceneMaterial{name, std::move(*reference), std::move(*needs)};
}

}  // namespace

Error of_material(const std::string& name, Error error) {
  if (!name.empty()) error.message.insert(0, shown(name, kQuotedLength) + ": ");
  return error;
}

Result<std::vector<SceneMaterial>> read_scene(const std::string& file,
                                              const std::string& reference) {
  const auto object = read_object(file, "scene");
  if (!object) return object.error();
  if (auto ok = check_fields(*object, "materials", kPrefix); !ok) return ok.error();
  const JsonValue* materials = find(*object, "materials");
  if (!reference.empty()) {
    if (materials != nullptr)
      return bad_value("scene.materials", "given beside --reference", "one of both");
    auto needs = scene_needs(*object);
    if (!needs) return needs.error();
    return std::vector<SceneMaterial>{{{}, reference, std::move(*needs)}};
  }
  if (materials == nullptr || materials->struct_value().fields().empty())
    return bad_value(
        "scene.materials", materials == nullptr ? "not given" : as_text(*materials),
        R"(materials by name, such as {"car": {"reference": "car.binary"}}; or --reference)");
  JsonObject of_all = *object;
  of_all.mutable_fields()->erase("materials");
  std::map<std::string, SceneMaterial> sorted;
  for (const auto& [name, value] : materials->struct_value().fields()) {
    if (auto ok = check_name(name); !ok) return ok.error();
    auto material = material_of(name, value, of_all, file);
    if (!material) return of_material(name, material.error());
    sorted.emplace(name, std::move(*material));
  }
  std::vector<SceneMaterial> all;
  for (auto& [name, material] : sorted) all.push_back(std::move(material));
  return all;
}

Result<std::map<std::string, double, std::less<>>> read_costs(const std::string& file) {
  const auto object = read_object(file, "costs");
  if (!object) return object.error();
  std::map<std::string, double, std::less<>> costs;
  for (const auto& [part, value] : object->fields()) {
    if (!value.has_number_value() || !(value.number_value() > 0))
      return bad_value("costs." + part, as_text(value), "a number above 0, in nanoseconds");
    costs[part] = value.number_value();
  }
  if (costs.empty()) return bad_value("costs", "empty", "a number for every part");
  return costs;
}

}  // namespace gonio::cli
