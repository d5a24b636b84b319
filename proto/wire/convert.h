// Between the core's enums and the wire's, and the JSON form of a material. Thread safety:
// functions without state.
#pragma once

#include <string_view>

#include "gonio/base/result.h"
#include "gonio/engine/isa.h"
#include "gonio/engine/random_numbers.h"
#include "gonio/models/description.h"
#include "gonio/v1/evaluate.pb.h"
#include "gonio/v1/material.pb.h"
#include "gonio/v1/sample.pb.h"

namespace gonio::wire {

gonio::v1::Precision to_wire(Precision precision);
gonio::v1::InstructionSet to_wire(Isa isa);
gonio::v1::ErrorBound to_wire(const ErrorBound& bound);

// UNSPECIFIED is fast. Errors: a number that the enum does not have.
Result<Precision> from_wire(gonio::v1::Precision precision);
// UNSPECIFIED is random. Errors: a number that the enum does not have.
Result<Sequence> from_wire(gonio::v1::Sequence sequence);
// Not for UNSPECIFIED, whose meaning depends on the processor. Errors: a number that the enum does
// not have.
Result<Isa> from_wire(gonio::v1::InstructionSet isa);

// Reads a material as people write it (see material.proto). Errors: what is wrong with the JSON,
// unknown fields.
Result<gonio::v1::Material> material_from_json(std::string_view json);

// protobuf's message about text that is no JSON, on one line: protobuf quotes the text on a second
// line.
std::string json_problem(std::string_view message);

}  // namespace gonio::wire
