// What the tool's exit status says, and how errors are shown. Thread safety: functions without
// state.
#pragma once

#include "gonio/base/result.h"

namespace gonio::cli {

enum ExitCode : int {
  exit_ok = 0,           // also when the reader of the results went away early
  exit_failed = 1,       // something went wrong on the way: writing the results, inside the server
  exit_bad_input = 2,    // wrong arguments, files, materials or directions
  exit_unreachable = 3,  // no answer from the server: not there, too busy, or past the deadline
  exit_bad_verdict =
      4,  // done, but not within the limits: `assess`, or nothing good enough: `select`
};

ExitCode exit_code_of(const Error& error);

// "gonio: error: ..." on stderr; returns the exit code.
ExitCode fail(const Error& error);

}  // namespace gonio::cli
