// A material of every model of the registry that can be fitted, in every combination of its words:
// with numbers that no fit starts from. Nothing here knows a model.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "fit/cases.h"
#include "fit/form.h"
#include "gonio/engine/registry.h"

namespace gonio::testing {

// One lobe for each combination of a model's words; no numbers.
inline std::vector<LobeSpec> lobes_of(const ModelDescription& model) {
  std::vector<LobeSpec> lobes{{std::string(model.name), {}}};
  for (const Parameter& p : model.parameters) {
    if (p.type != ParameterType::word) continue;
    std::vector<LobeSpec> more;
    for (const LobeSpec& lobe : lobes) {
      for (const std::string_view word : p.words) {
        more.push_back(lobe);
        more.back().parameters[std::string(p.name)] = std::string(word);
      }
    }
    lobes = std::move(more);
  }
  return lobes;
}

inline LobeSpec& lobe_at(MaterialSpec& spec, std::size_t lobe) {
  if (spec.model) return *spec.model;
  return spec.diffuse && lobe == 0 ? *spec.diffuse : spec.specular[lobe - (spec.diffuse ? 1 : 0)];
}

// Off the start by a seventh of the way that a scan takes upwards; of several in turn up and down.
inline double shape_for_tests(const fit::ShapeParameter& shape, std::size_t index) {
  const double start = shape.scale.to_search(shape.start);
  const double end = shape.scale.to_search(index % 2 == 0 ? shape.scan_upper : shape.scan_lower);
  return shape.scale.to_parameter(start + (end - start) / 7);
}

// One for each of three channels, between the bounds of the table or, of a wide one, up to 1.
inline std::vector<double> colour_for_tests(const Parameter& p, double most) {
  const double upper = std::min(p.upper, 1.0), lower = std::min(p.lower, upper);
  std::vector<double> colour;
  for (const double part : {0.9, 0.5, 0.3}) colour.push_back(std::lerp(lower, upper, part * most));
  return colour;
}

// The numbers of a form, chosen as above. A product of two colours tells one of them: the other is
// the 1 that a fit makes of it.
inline MaterialSpec with_numbers(MaterialSpec spec, const fit::Form& form) {
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const fit::ShapeParameter& shape = form.shapes[i];
    for (const std::string& name : shape.names)
      lobe_at(spec, shape.lobe).parameters[name] = std::vector{shape_for_tests(shape, i)};
  }
  for (std::size_t i = 0; i < form.lobes.size(); ++i) {
    const fit::LobeColours& colours = form.lobes[i].colours;
    auto& parameters = lobe_at(spec, i).parameters;
    const bool product = colours.columns == fit::Columns::scaled && colours.reflectance != nullptr;
    if (colours.scale != nullptr && !product)
      parameters[std::string(colours.scale->name)] = colour_for_tests(*colours.scale, 1);
    if (colours.reflectance != nullptr)
      parameters[std::string(colours.reflectance->name)] =
          colour_for_tests(*colours.reflectance, 0.6);
    if (colours.diffuse != nullptr)
      parameters[std::string(colours.diffuse->name)] = colour_for_tests(*colours.diffuse, 0.5);
  }
  return spec;
}

inline std::string name_of_lobe(const LobeSpec& lobe) {
  std::string name = lobe.model;
  for (const auto& [parameter, word] : lobe.parameters) name += "_" + std::get<std::string>(word);
  return name;
}

// Alone and, of a specular model, over a base; the pairs of numbers along the tangents held equal
// and, where there are such, not.
inline std::vector<Case> registry_cases() {
  std::vector<Case> all;
  const auto add = [&](const std::string& name, const MaterialSpec& spec) {
    const auto equal = fit::make_form(spec, {}), apart = fit::make_form(spec, {true});
    if (!equal || !apart) return;
    all.push_back({name, with_numbers(spec, *equal)});
    if (apart->shapes.size() > equal->shapes.size())
      all.push_back({name + "_anisotropic", with_numbers(spec, *apart), true});
  };
  for (const ModelDescription& model : models()) {
    if (model.role == Role::measured) continue;
    for (const LobeSpec& lobe : lobes_of(model)) {
      add(name_of_lobe(lobe) + "_alone", {lobe, {}, {}});
      if (model.role == Role::specular)
        add(name_of_lobe(lobe), {{}, LobeSpec{"lambertian", {}}, {lobe}});
    }
  }
  return all;
}

}  // namespace gonio::testing
