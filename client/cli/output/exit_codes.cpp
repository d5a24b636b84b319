#include "client/cli/output/exit_codes.h"

#include "client/cli/output/terminal.h"

namespace gonio::cli {

ExitCode fail(const Error& error) {
  print_error(error.message);
  return exit_code_of(error);
}

}  // namespace gonio::cli
