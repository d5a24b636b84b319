// That no result is written over another one, or over what is read. Thread safety: no state.
#pragma once

#include <string>
#include <vector>

#include "gonio/base/result.h"

namespace gonio::cli {

// A file by the option that names it; no text where it is not given.
struct NamedFile {
  std::string option, file;
};

// Errors: two outputs go to one place, or an output to a file that is an input. Devices and pipes
// take any number.
Outcome check_outputs(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs);

}  // namespace gonio::cli
