#include "select/candidates.h"

#include <optional>
#include <utility>

#include "fit/form.h"
#include "gonio/engine/registry.h"

namespace gonio::select {
namespace {

// One model with one choice of its words.
struct Variant {
  std::string name;
  LobeSpec lobe;
  Role role;
};

std::vector<Variant> variants_of(const ModelDescription& model) {
  const std::string name(model.name);
  std::vector<Variant> variants{{name, {name, {}}, model.role}};
  for (const Parameter& p : model.parameters) {
    if (p.type != ParameterType::word) continue;
    std::vector<Variant> longer;
    for (const Variant& variant : variants) {
      for (const std::string_view word : p.words) {
        longer.push_back(variant);
        longer.back().name += ":" + std::string(word);
        longer.back().lobe.parameters[std::string(p.name)] = std::string(word);
      }
    }
    variants = std::move(longer);
  }
  return variants;
}

// What stands under lobes: the first diffuse model that is one colour and nothing else.
std::optional<Variant> plainest_base() {
  for (const ModelDescription& model : models()) {
    if (model.role != Role::diffuse || model.parameters.size() != 1) continue;
    for (Variant& variant : variants_of(model)) {
      const auto form = fit::make_form({variant.lobe, {}, {}}, {});
      if (form && form->shapes.empty() && form->coefficients == 1) return std::move(variant);
    }
  }
  return {};
}

class List {
 public:
  List(const Scene& scene, int channels) : scene_(scene), channels_(channels) {}

  // One candidate with the pairs of numbers held equal and, if the model has such pairs, one with
  // both free; none if it cannot be fitted.
  void add(const std::string& name, std::vector<std::string> parts, const MaterialSpec& form) {
    const auto equal = count(form, false), apart = count(form, true);
    if (!equal || !apart) return;
    all_.push_back({name, parts, form, false, *equal});
    if (scene_.anisotropy && *apart != *equal && form.specular.size() < 2)
      all_.push_back({name + ", anisotropic", std::move(parts), form, true, *apart});
  }

  std::vector<Candidate> take() && { return std::move(all_); }

 private:
  [[nodiscard]] std::optional<std::size_t> count(const MaterialSpec& spec, bool anisotropic) const {
    const auto form = fit::make_form(spec, {anisotropic, anisotropic});
    if (!form) return {};
    return form->parameters(channels_);
  }
  const Scene& scene_;
  int channels_;
  std::vector<Candidate> all_;
};

bool has_one_shape(const LobeSpec& lobe) {
  const auto form = fit::make_form({{}, {}, {lobe}}, {false});
  return form && form->shapes.size() == 1;
}

}  // namespace

std::vector<Candidate> candidates(const Scene& scene, int channels, int lobes) {
  List list(scene, channels);
  const std::optional<Variant> base = plainest_base();
  for (const ModelDescription& model : models()) {
    if (model.role == Role::measured) continue;
    for (const auto& [name, lobe, role] : variants_of(model)) {
      list.add(name, {name}, {lobe, {}, {}});
      if (role != Role::specular || !base) continue;
      list.add(base->name + " + " + name, {base->name, name}, {{}, base->lobe, {lobe}});
      if (lobes > 1 && has_one_shape(lobe))
        list.add(base->name + " + 2 " + name, {base->name, name, name},
                 {{}, base->lobe, {lobe, lobe}});
    }
  }
  return std::move(list).take();
}

MaterialSpec with_channels(const MaterialSpec& form, int channels) {
  MaterialSpec spec = form;
  const auto widen = [&](LobeSpec& lobe) {
    for (const Parameter& p : (*find_model(lobe.model))->parameters) {
      if (p.type != ParameterType::colour || !p.used_with.parameter.empty()) continue;
      lobe.parameters[std::string(p.name)] =
          std::vector<double>(static_cast<std::size_t>(channels), p.start);
    }
  };
  if (spec.model) widen(*spec.model);
  if (spec.diffuse) widen(*spec.diffuse);
  for (LobeSpec& lobe : spec.specular) widen(lobe);
  return spec;
}

}  // namespace gonio::select
