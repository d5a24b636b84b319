// That no result is written over another one, or over what is read. Thread safety: no state.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
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

// Errors: a file whose extension promises a format that is not written. Without one, "-", devices
// and pipes take anything. `extensions`: ".csv", in lower case.
Outcome check_extension(const NamedFile& output, std::initializer_list<std::string_view> extensions,
                        const std::string& or_else = {});

// Errors: two inputs of which both are "-", standard input.
Outcome check_standard_input(const std::vector<NamedFile>& inputs);

}  // namespace gonio::cli
