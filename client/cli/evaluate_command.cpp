#include <CLI/CLI.hpp>
#include <memory>

#include "client/cli/commands.h"
#include "client/cli/evaluate_arguments.h"
#include "client/cli/evaluate_run.h"
#include "client/cli/exit_codes.h"
