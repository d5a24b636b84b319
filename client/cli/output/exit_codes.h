// How errors are shown; what the exit status says is in base/exit_code.h. Thread safety: a function
// without state.
#pragma once

#include "base/exit_code.h"
#include "gonio/base/result.h"

namespace gonio::cli {

// "gonio: error: ..." on stderr; returns the exit code.
ExitCode fail(const Error& error);

}  // namespace gonio::cli
