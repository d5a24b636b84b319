#include "server/messages/list_models.h"

#include <string>

#include "gonio/base/version.h"
#include "gonio/engine/isa.h"
#include "gonio/engine/registry.h"
#include "wire/convert.h"

namespace gonio::server {
namespace {

v1::ModelRole to_wire(Role role) {
  switch (role) {
    case Role::diffuse:
      return v1::MODEL_ROLE_DIFFUSE;
    case Role::specular:
      return v1::MODEL_ROLE_SPECULAR;
    case Role::measured:
      return v1::MODEL_ROLE_MEASURED;
  }
  return v1::MODEL_ROLE_UNSPECIFIED;
}

void fill(const Preset& from, v1::Preset& to) {
  to.set_name(std::string(from.name));
  to.mutable_values()->Assign(from.rgb.begin(), from.rgb.end());
  to.set_source(std::string(from.source));
}

void fill(const Parameter& from, v1::Parameter& to) {
  to.set_name(std::string(from.name));
  to.set_meaning(std::string(from.meaning));
  to.set_unit(std::string(from.unit));
  to.set_lower(from.lower);
  to.set_upper(from.upper);
  to.set_start(from.start);
  to.set_logarithmic(from.scale == Scale::logarithmic);
  to.set_colour(from.type == ParameterType::colour);
  to.set_file(from.type == ParameterType::file);
  for (std::string_view word : from.words) to.add_words(std::string(word));
  to.set_used_with(std::string(from.used_with.parameter));
  for (std::string_view word : from.used_with.words) to.add_used_with_words(std::string(word));
  for (const Preset& preset : from.presets) fill(preset, *to.add_presets());
  to.set_preset_partner(std::string(from.preset_partner));
}

void fill(const ModelDescription& from, v1::Model& to) {
  to.set_name(std::string(from.name));
  to.set_summary(std::string(from.summary));
  to.set_source(std::string(from.source));
  to.set_role(to_wire(from.role));
  for (const Parameter& parameter : from.parameters) fill(parameter, *to.add_parameters());
  to.set_albedo_limit(from.albedo_limit);
  *to.mutable_fast() = wire::to_wire(from.fast);
  *to.mutable_reference() = wire::to_wire(from.reference);
}

}  // namespace

Result<v1::ListModelsResponse> list_models(const v1::ListModelsRequest& request,
                                           const Materials& materials) {
  v1::ListModelsResponse response;
  if (request.name().empty()) {
    for (const ModelDescription& model : models()) fill(model, *response.add_models());
  } else {
    const auto model = find_model(request.name());
    if (!model) return model.error();
    fill(**model, *response.add_models());
  }
  for (const std::string& name : materials.names()) response.add_materials(name);
  for (const Skipped& skipped : materials.skipped()) {
    v1::SkippedMaterial& to = *response.add_skipped_materials();
    to.set_name(skipped.name);
    to.set_reason(skipped.reason);
  }
  for (Isa isa : supported_isas()) response.add_instruction_sets(wire::to_wire(isa));
  response.set_version(kVersion);
  return response;
}

}  // namespace gonio::server
