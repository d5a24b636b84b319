// Between the wire's messages and the client's types. Internal to the client library. Thread
// safety: no state.
#pragma once

#include "gonio/client/models.h"
#include "gonio/client/sampling.h"
#include "gonio/client/types.h"
#include "gonio/v1/evaluate.pb.h"
#include "gonio/v1/models.pb.h"
#include "gonio/v1/sample.pb.h"

namespace gonio::client {

gonio::v1::InstructionSet to_wire(InstructionSet set);
gonio::v1::Precision to_wire(Precision precision);
gonio::v1::Sequence to_wire(Sequence sequence);

InstructionSet instruction_set_of(
    gonio::v1::InstructionSet set);  // `best` for one that is not known
ErrorBound error_bound_of(const gonio::v1::ErrorBound& bound);
Catalogue catalogue_of(const gonio::v1::ListModelsResponse& response);

}  // namespace gonio::client
