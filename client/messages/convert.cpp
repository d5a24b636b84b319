#include "client/messages/convert.h"

#include "wire/mapping/error_bound.h"

namespace gonio::client {
namespace {

static_assert(int{flag::not_unit} == gonio::v1::PAIR_FLAG_NOT_UNIT);
static_assert(int{flag::not_finite} == gonio::v1::PAIR_FLAG_NOT_FINITE);
static_assert(int{flag::zero} == gonio::v1::PAIR_FLAG_ZERO);
static_assert(int{flag::incident_below_horizon} == gonio::v1::PAIR_FLAG_INCIDENT_BELOW_HORIZON);
static_assert(int{flag::outgoing_below_horizon} == gonio::v1::PAIR_FLAG_OUTGOING_BELOW_HORIZON);
static_assert(int{flag::outside_data} == gonio::v1::PAIR_FLAG_OUTSIDE_DATA);
static_assert(int{flag::bad_number} == gonio::v1::PAIR_FLAG_BAD_NUMBER);
static_assert(int{flag::hole} == gonio::v1::PAIR_FLAG_HOLE);

Role role_of(gonio::v1::ModelRole role) {
  switch (role) {
    case gonio::v1::MODEL_ROLE_DIFFUSE:
      return Role::diffuse;
    case gonio::v1::MODEL_ROLE_SPECULAR:
      return Role::specular;
    case gonio::v1::MODEL_ROLE_MEASURED:
      return Role::measured;
    default:
      return Role::unknown;
  }
}

ParameterInfo parameter_of(const gonio::v1::Parameter& parameter) {
  ParameterInfo info;
  info.name = parameter.name();
  info.meaning = parameter.meaning();
  info.unit = parameter.unit();
  info.lower = parameter.lower();
  info.upper = parameter.upper();
  info.start = parameter.start();
  info.logarithmic = parameter.logarithmic();
  info.colour = parameter.colour();
  info.words.assign(parameter.words().begin(), parameter.words().end());
  info.used_with = parameter.used_with();
  info.used_with_words.assign(parameter.used_with_words().begin(),
                              parameter.used_with_words().end());
  for (const auto& preset : parameter.presets()) {
    info.presets.push_back(
        {preset.name(), {preset.values().begin(), preset.values().end()}, preset.source()});
  }
  info.preset_partner = parameter.preset_partner();
  info.file = parameter.file();
  return info;
}

ModelInfo model_of(const gonio::v1::Model& model) {
  ModelInfo info;
  info.name = model.name();
  info.summary = model.summary();
  info.source = model.source();
  info.role = role_of(model.role());
  for (const auto& parameter : model.parameters())
    info.parameters.push_back(parameter_of(parameter));
  info.fast = error_bound_of(model.fast());
  info.reference = error_bound_of(model.reference());
  info.albedo_limit = model.albedo_limit();
  return info;
}

}  // namespace

gonio::v1::InstructionSet to_wire(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return gonio::v1::INSTRUCTION_SET_BASELINE;
    case InstructionSet::avx2:
      return gonio::v1::INSTRUCTION_SET_AVX2;
    case InstructionSet::avx512:
      return gonio::v1::INSTRUCTION_SET_AVX512;
    case InstructionSet::best:
      break;
  }
  return gonio::v1::INSTRUCTION_SET_UNSPECIFIED;
}

gonio::v1::Precision to_wire(Precision precision) {
  return precision == Precision::reference ? gonio::v1::PRECISION_REFERENCE
                                           : gonio::v1::PRECISION_FAST;
}

gonio::v1::Sequence to_wire(Sequence sequence) {
  return sequence == Sequence::sobol ? gonio::v1::SEQUENCE_SOBOL : gonio::v1::SEQUENCE_RANDOM;
}

InstructionSet instruction_set_of(gonio::v1::InstructionSet set) {
  switch (set) {
    case gonio::v1::INSTRUCTION_SET_BASELINE:
      return InstructionSet::baseline;
    case gonio::v1::INSTRUCTION_SET_AVX2:
      return InstructionSet::avx2;
    case gonio::v1::INSTRUCTION_SET_AVX512:
      return InstructionSet::avx512;
    default:
      return InstructionSet::best;
  }
}

ErrorBound error_bound_of(const gonio::v1::ErrorBound& bound) {
  return wire::from_message<ErrorBound>(bound).value();  // of numbers and texts alone
}

Catalogue catalogue_of(const gonio::v1::ListModelsResponse& response) {
  Catalogue catalogue;
  for (const auto& model : response.models()) catalogue.models.push_back(model_of(model));
  catalogue.materials.assign(response.materials().begin(), response.materials().end());
  for (const auto& skipped : response.skipped_materials())
    catalogue.skipped_materials.push_back({skipped.name(), skipped.reason()});
  for (const auto set : response.instruction_sets()) {
    catalogue.instruction_sets.push_back(
        instruction_set_of(static_cast<gonio::v1::InstructionSet>(set)));
  }
  catalogue.server_version = response.version();
  return catalogue;
}

}  // namespace gonio::client
