// What ListModels says. Thread safety: a function without state.
#pragma once

#include "gonio/base/result.h"
#include "gonio/v1/models.pb.h"
#include "server/materials/materials.h"

namespace gonio::server {

// Errors: not_found, with the models that exist.
Result<v1::ListModelsResponse> list_models(const v1::ListModelsRequest& request,
                                           const Materials& materials);

}  // namespace gonio::server
