#include "client/cli/exit_codes.h"

#include "client/cli/terminal.h"

namespace gonio::cli {

ExitCode fail(const Error& error) {
  print_error(error.message);
  return exit_code_of(error);
}

}  // namespace gonio::cli
