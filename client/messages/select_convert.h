// Selections between the client's types and the wire's messages. Internal to the client library.
// Thread safety: no state.
#pragma once

#include "gonio/base/result.h"
#include "gonio/client/select.h"
#include "gonio/v1/select.pb.h"

namespace gonio::client {

// Errors: a material that cannot be read; too many pairs; numbers for which 0 would mean the
// default.
Result<gonio::v1::SelectRequest> select_request(const SelectReference& reference,
                                                const SelectScene& scene,
                                                const SelectOptions& options);
SelectProgress progress_of(const gonio::v1::SelectProgress& progress);
Result<Selection> selection_of(const gonio::v1::SelectResult& result);

}  // namespace gonio::client
