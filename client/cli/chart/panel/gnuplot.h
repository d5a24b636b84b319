// Runs gnuplot. Thread safety: functions without state.
#pragma once

#include <string>
#include <vector>

#include "gonio/base/result.h"

namespace gonio::cli {

struct Drawing {
  std::string file;  // "models.svg"
  std::string bytes;
};

// What a script draws: the files NAME.svg and NAME.png that it writes into the folder where it
// runs, which is a temporary one. Errors: not_found if there is no gnuplot; internal with what it
// says.
Result<std::vector<Drawing>> run_gnuplot(const std::string& script, const std::string& name);

}  // namespace gonio::cli
