// What `gonio fit --model` names: the materials whose parameters are fitted. Thread safety: plain
// values, a function without state.
#pragma once

#include <string>
#include <vector>

#include "client/cli/arguments/fit_arguments.h"
#include "gonio/base/result.h"
#include "gonio/client/material.h"
#include "gonio/client/models.h"

namespace gonio::cli {

// What is fitted, and what it is called in the results: "ggx:schlick".
struct FitForm {
  std::string name;
  client::Material material;
};

// One for each of `--model`; "all" is every analytic model. Errors: a model or base that does not
// exist, or a model that lacks the word that is asked for.
Result<std::vector<FitForm>> fit_forms(const FitArguments& arguments,
                                       const client::Catalogue& catalogue);

}  // namespace gonio::cli
