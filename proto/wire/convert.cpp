#include "wire/convert.h"

#include <google/protobuf/util/json_util.h>

#include <string>

#include "wire/material_keys.h"

namespace gonio::wire {

gonio::v1::Precision to_wire(Precision precision) {
  return precision == Precision::fast ? gonio::v1::PRECISION_FAST : gonio::v1::PRECISION_REFERENCE;
}

gonio::v1::InstructionSet to_wire(Isa isa) {
  switch (isa) {
    case Isa::baseline:
      return gonio::v1::INSTRUCTION_SET_BASELINE;
    case Isa::avx2:
      return gonio::v1::INSTRUCTION_SET_AVX2;
    case Isa::avx512:
      return gonio::v1::INSTRUCTION_SET_AVX512;
  }
  return gonio::v1::INSTRUCTION_SET_UNSPECIFIED;
}

v1::ErrorBound to_wire(const ErrorBound& bound) {
  v1::ErrorBound to;
  to.set_relative(bound.relative);
  to.set_above(bound.above);
  to.set_cosine(bound.cosine);
  to.set_note(std::string(bound.note));
  return to;
}

Result<Precision> from_wire(gonio::v1::Precision precision) {
  switch (precision) {
    case gonio::v1::PRECISION_UNSPECIFIED:
    case gonio::v1::PRECISION_FAST:
      return Precision::fast;
    case gonio::v1::PRECISION_REFERENCE:
      return Precision::reference;
    default:
      return bad_value("precision", std::to_string(static_cast<int>(precision)),
                       "PRECISION_FAST (1) or PRECISION_REFERENCE (2)");
  }
}

Result<Sequence> from_wire(gonio::v1::Sequence sequence) {
  switch (sequence) {
    case gonio::v1::SEQUENCE_UNSPECIFIED:
    case gonio::v1::SEQUENCE_RANDOM:
      return Sequence::random;
    case gonio::v1::SEQUENCE_SOBOL:
      return Sequence::sobol;
    default:
      return bad_value("sequence", std::to_string(static_cast<int>(sequence)),
                       "SEQUENCE_RANDOM (1) or SEQUENCE_SOBOL (2)");
  }
}

Result<Isa> from_wire(gonio::v1::InstructionSet isa) {
  switch (isa) {
    case gonio::v1::INSTRUCTION_SET_BASELINE:
      return Isa::baseline;
    case gonio::v1::INSTRUCTION_SET_AVX2:
      return Isa::avx2;
    case gonio::v1::INSTRUCTION_SET_AVX512:
      return Isa::avx512;
    default:
      return bad_value(
          "instruction_set", std::to_string(static_cast<int>(isa)),
          "INSTRUCTION_SET_BASELINE (1), INSTRUCTION_SET_AVX2 (2) or INSTRUCTION_SET_AVX512 (3)");
  }
}

Result<gonio::v1::Material> material_from_json(std::string_view json) {
  gonio::v1::Material material;
  const auto status = google::protobuf::util::JsonStringToMessage(
      google::protobuf::StringPiece(json.data(), json.size()), &material);
  if (status.ok()) return material;
  if (auto known = check_material_keys(json); !known) return known.error();
  return Error{
      ErrorCode::invalid_argument,
      "not the JSON of a material: " +
          std::string(status.message().data(), status.message().size()),
      "", "",
      R"({"name": ...}, {"model": ..., "parameters": {...}} or {"diffuse": ..., "specular": [...]})"};
}

}  // namespace gonio::wire
