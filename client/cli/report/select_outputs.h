// Where `gonio select` puts what it found. Thread safety: used by one thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cli/arguments/select_arguments.h"
#include "client/cli/output/output_file.h"
#include "client/cli/report/select_report.h"
#include "client/cli/scene/scene_file.h"
#include "gonio/base/result.h"

namespace gonio::cli {

class SelectOutputs {
 public:
  // Before the work: what cannot be written shows then. Materials by name go into a folder, which
  // is made and stays. Errors: a place that cannot be written, is read, or takes two results.
  static Result<SelectOutputs> open(const SelectArguments& arguments,
                                    const std::vector<SceneMaterial>& materials);
  // A choice that is the reference itself is not written: it is where it was.
  Outcome write(const std::vector<NamedSelection>& found);

 private:
  std::string output_;                         // a file or a folder; empty: none
  std::optional<OutputFile> report_, choice_;  // the choice of a scene without names
};

}  // namespace gonio::cli
