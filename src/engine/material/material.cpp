#include "gonio/engine/material.h"

#include <algorithm>
#include <cmath>

#include "engine/material/lobe_check.h"
#include "engine/material/material_impl.h"
#include "engine/material/registry.h"
#include "measured/merl/part.h"

namespace gonio {
namespace {

// The lobes of a specification with the field each came from, or what is wrong with the whole.
Result<std::vector<NamedLobe>> list_lobes(const MaterialSpec& spec, std::string_view prefix) {
  const std::string at(prefix);
  const bool sum = spec.diffuse.has_value() || !spec.specular.empty();
  if (spec.model.has_value() == sum) {
    return bad_value(at.empty() ? "material" : at.substr(0, at.size() - 1),
                     sum ? "a model and a sum" : "empty",
                     "one model, or a sum of a diffuse base and specular lobes");
  }
  if (spec.specular.size() > static_cast<std::size_t>(kMaxSpecularLobes)) {
    return bad_value(at + "specular", std::to_string(spec.specular.size()) + " lobes",
                     "at most " + std::to_string(kMaxSpecularLobes));
  }
  std::vector<NamedLobe> lobes;
  if (spec.model) lobes.push_back({&*spec.model, at, std::nullopt});
  if (spec.diffuse) lobes.push_back({&*spec.diffuse, at + "diffuse.", Role::diffuse});
  for (std::size_t i = 0; i < spec.specular.size(); ++i) {
    lobes.push_back(
        {&spec.specular[i], at + "specular[" + std::to_string(i) + "].", Role::specular});
  }
  return lobes;
}

ErrorBound worse(const ErrorBound& a, const ErrorBound& b) {
  return a.relative < b.relative ? b : a;
}

void turn(CheckedLobe& lobe, double degrees) { lobe.values.set(kRotation.name, {degrees}); }

}  // namespace

Outcome check_rotation(double degrees, std::string_view prefix) {
  ChannelCount one;
  const auto checked = check_numbers(std::string(prefix) + std::string(kRotation.name), kRotation,
                                     std::vector{degrees}, one);
  if (!checked) return checked.error();
  return Ok{};
}

Result<CheckedMaterial> check_material(const MaterialSpec& spec, std::string_view prefix) {
  Result<std::vector<NamedLobe>> named = list_lobes(spec, prefix);
  if (!named) return named.error();
  CheckedMaterial material{std::move(named).value(), {}};
  ChannelCount channels;
  for (const NamedLobe& lobe : material.named) {
    Result<CheckedLobe> checked = check_lobe(lobe, channels);
    if (!checked) return checked.error();
    material.lobes.push_back(std::move(checked).value());
  }
  material.channels = channels.count;
  material.rotation = spec.rotation.value_or(kRotation.start);
  if (Outcome rotation = check_rotation(material.rotation, prefix); !rotation)
    return rotation.error();
  for (CheckedLobe& lobe : material.lobes) turn(lobe, material.rotation);
  return material;
}

Result<Material> Material::create(const MaterialSpec& spec, std::string_view prefix) {
  const Result<CheckedMaterial> checked = check_material(spec, prefix);
  if (!checked) return checked.error();
  auto impl = std::make_shared<Impl>();
  impl->channels = checked->channels;
  impl->rotation = checked->rotation;
  for (const CheckedLobe& lobe : checked->lobes) impl->add(make_part(lobe, impl->channels));
  return Material(std::move(impl));
}

Result<Material> Material::from_file(const LobeSpec& spec, std::string_view prefix,
                                     const FindFile& find_file) {
  const Result<CheckedLobe> lobe = check_measured({&spec, std::string(prefix), std::nullopt});
  if (!lobe) return lobe.error();
  const Result<std::filesystem::path> path = find_file(lobe->file);
  if (!path) return path.error();
  Result<Part> part = part_model(*lobe->model).read(*path, *lobe);
  if (!part) return part.error();
  auto impl = std::make_shared<Impl>();
  impl->channels = part->channels;
  impl->add(std::move(part).value());
  return Material(std::move(impl));
}

Material Material::from_table(std::shared_ptr<const MeasuredTable> table,
                              Interpolation interpolation) {
  auto impl = std::make_shared<Impl>();
  impl->add(merl_part(std::move(table), interpolation));
  impl->channels = impl->parts.front().channels;
  return Material(std::move(impl));
}

void Material::Impl::add(Part part) {
  fast = worse(fast, part.lobe->model->fast);
  reference = worse(reference, part.lobe->model->reference);
  bytes += part.made.bytes;
  parts.push_back(std::move(part));
}

std::shared_ptr<const MeasuredTable> table_of(const Material& material) {
  const Part& first = material.impl().parts.front();
  return first.kind->table == nullptr ? nullptr : first.kind->table(first);
}

bool Material::has_tangents() const {
  return std::any_of(impl_->parts.begin(), impl_->parts.end(),
                     [](const Part& part) { return part.lobe->model->has_tangents(); });
}

Material Material::turned(double degrees) const {
  if (!has_tangents()) return *this;
  auto impl = std::make_shared<Impl>();
  impl->channels = impl_->channels;
  impl->rotation = std::remainder(impl_->rotation + degrees, 360.0);
  for (const Part& part : impl_->parts) {
    CheckedLobe lobe = *part.lobe;
    turn(lobe, impl->rotation);
    impl->add(make_part(lobe, impl->channels));
  }
  return Material(std::move(impl));
}

int Material::channels() const { return impl_->channels; }
std::size_t Material::bytes() const { return impl_->bytes; }

ErrorBound Material::error_bound(Precision precision) const {
  return precision == Precision::fast ? impl_->fast : impl_->reference;
}

}  // namespace gonio
