#include "client/cli/exit_codes.h"

#include <cstdio>

namespace gonio::cli {

ExitCode fail(const Error& error) {
  std::fprintf(stderr, "gonio: error: %s\n", error.message.c_str());
  return exit_code_of(error);
}

}  // namespace gonio::cli
