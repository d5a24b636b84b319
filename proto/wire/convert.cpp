#include "wire/convert.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <string>

#include "base/text/encoding.h"
#include "gonio/base/shown.h"
#include "wire/mapping/error_bound.h"
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

v1::ErrorBound to_wire(const ErrorBound& bound) { return to_message(stated(bound)); }

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

std::string json_problem(std::string_view message) {
  const std::size_t end = std::min(message.find('\n'), message.size());
  std::string problem = shown(message.substr(0, end), kQuotedLength);
  message.remove_prefix(std::min(end + 1, message.size()));
  const std::string_view quoted = message.substr(0, message.find('\n'));
  if (!quoted.empty()) problem += " Near '" + shown(quoted, kQuotedLength) + "'";
  return problem;
}

Result<gonio::v1::Material> material_from_json(std::string_view json) {
  const auto text = utf8_text(json, "the JSON of a material");
  if (!text) return text.error();
  gonio::v1::Material material;
  const auto status = google::protobuf::util::JsonStringToMessage(
      google::protobuf::StringPiece(text->data(), text->size()), &material);
  if (status.ok()) return material;
  if (auto known = check_material_keys(*text); !known) return known.error();
  return Error{
      ErrorCode::invalid_argument,
      "not the JSON of a material: " +
          json_problem({status.message().data(), status.message().size()}),
      "", "",
      R"({"name": ...}, {"model": ..., "parameters": {...}} or {"diffuse": ..., "specular": [...]})"};
}

}  // namespace gonio::wire
