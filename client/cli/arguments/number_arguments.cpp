#include "client/cli/arguments/number_arguments.h"

#include "server/arguments/options.h"

namespace gonio::cli {

client::NumberSource NumberArguments::source() const {
  const bool sobol = sequence == "sobol";
  return {sobol ? client::Sequence::sobol : client::Sequence::random, seed};
}

void add_number_options(CLI::App& command, NumberArguments& arguments) {
  arguments::add_option(command, "--count", arguments.count, "Samples of each wi").type_name("N");
  arguments::add_option(command, "--seed", arguments.seed,
                        "Chooses the numbers they are drawn by; 0 if not given")
      .type_name("S");
  arguments::add_option(command, "--sequence", arguments.sequence,
                        "random (independent, the default) or sobol (evenly spread)")
      .type_name("Q")
      .one_of({"random", "sobol"});
}

Outcome check_count(const NumberArguments& arguments, std::uint64_t least,
                    std::uint64_t directions) {
  const std::uint64_t most = directions == 0 ? kMostSamples : kMostSamples / directions;
  if (arguments.count >= 0 && arguments.per_wi() >= least && arguments.per_wi() <= most)
    return Ok{};
  return bad_value("--count", std::to_string(arguments.count),
                   std::to_string(least) + " to " + std::to_string(kMostSamples) +
                       ", all wi together" +
                       (directions > 1 ? " (there are " + std::to_string(directions) + ")" : ""));
}

}  // namespace gonio::cli
