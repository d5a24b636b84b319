// Reads a message in its canonical form without a copy of its arrays. Internal to wire/.
//
// False: the bytes are legal in another form, or not at all; the generated parser should look.
// Thread safety: functions without state.
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
