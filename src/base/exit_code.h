// What the exit status of gonio and goniod says: one table for both programs and their help. Thread
// safety: functions without state.
#pragma once

#include <span>
#include <string>

#include "gonio/base/result.h"

namespace gonio {

enum ExitCode : int {
  exit_ok = 0,           // also when the reader of the results went away early
  exit_failed = 1,       // something went wrong on the way: writing the results, inside the server
  exit_bad_input = 2,    // wrong arguments, files, materials or directions
  exit_unreachable = 3,  // no answer from the server: not there, too busy, or past the deadline
  exit_bad_verdict = 4,  // done, but not within the limits, or nothing good enough
};

ExitCode exit_code_of(const Error& error);

// "Exit status: 0 done; ..." for a help page, with those of `codes`.
std::string exit_status_text(std::span<const ExitCode> codes);

}  // namespace gonio
