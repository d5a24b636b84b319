// Reads a message in its canonical form without a copy of its arrays. Internal to wire/.
//
// Returns false for bytes that are legal in another form, or not legal; the generated parser
// decides. Thread safety: functions without state.
#pragma once

#include "wire/codec.h"
#include "wire/fields.h"

namespace gonio::wire {

bool scan(const SliceBytes& bytes, Range range, Request& out);
bool scan(const SliceBytes& bytes, Range range, SampleRequest& out);
bool scan(const SliceBytes& bytes, Range range, IntegrateRequest& out);
bool scan(const SliceBytes& bytes, Range range, Response& out);
bool scan(const SliceBytes& bytes, Range range, SampleResponse& out);

}  // namespace gonio::wire
