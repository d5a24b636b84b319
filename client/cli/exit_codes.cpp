#include "client/cli/exit_codes.h"

#include "client/cli/terminal.h"

namespace gonio::cli {

ExitCode exit_code_of(const Error& error) {
  switch (error.code) {
    case ErrorCode::invalid_argument:
    case ErrorCode::not_found:
    case ErrorCode::already_exists:
    case ErrorCode::data_loss:
      return exit_bad_input;
    case ErrorCode::resource_exhausted:  // with a bound it is too large, else the server is too
                                         // busy
      return error.allowed.empty() ? exit_unreachable : exit_bad_input;
    case ErrorCode::unavailable:
    case ErrorCode::deadline_exceeded:
      return exit_unreachable;
    case ErrorCode::cancelled:
    case ErrorCode::internal:
      break;
  }
  return exit_failed;
}

ExitCode fail(const Error& error) {
  print_error(error.message);
  return exit_code_of(error);
}

}  // namespace gonio::cli
