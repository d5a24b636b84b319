#include "client/cli/arguments/evaluate_arguments.h"

#include "client/cli/output/check_outputs.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr const char* kInput = R"(
Pairs: CSV with the header wi_x,wi_y,wi_z,wo_x,wo_y,wo_z (directions away from the surface, whose
normal is 0,0,1; lengths within 0.001 of 1 are corrected) or theta_i,phi_i,theta_o,phi_o (angles in
radians, or degrees with --deg; theta from the normal). Other columns are ignored. Or an NPY file:
float32 or float64, N x 6, columns as in the first header.

Grid: AXIS=ANGLES,AXIS=ANGLES,... with the axes theta_i, phi_i, theta_o, phi_o (the last the fastest;
one that is not given is 0), or the half-angle axes theta_h, theta_d, phi_d. ANGLES is
START:STOP:COUNT with both ends included, or a list such as 0/15/40. At most 1000000000 pairs.

Results: the BRDF's values in 1/sr, without a cosine; with --pdf also the density, per steradian,
with which 'gonio sample' draws wo for wi.
  csv   f_0,f_1,...,flags: one column a channel (9 digits for fast, 17 for reference) and the flags
  npy   N x channels, float32 for fast, float64 for reference; the flags are summed up on stderr
  json  {"channels": C, "values": [[f_0, ...], ...], "flags": [...], "report": {...}}
A pdf is the column after the channels. A pair that cannot be evaluated has the value 0 and flags, the
sum of: )";

constexpr const char* kExamples = R"(.

Examples:
  gonio evaluate --material copper.json --grid theta_i=0:80:9,theta_o=0:90:91,phi_o=0/180 --deg \
      --with-input > plane.csv
  gonio evaluate --material gold.binary --pairs pairs.npy -o values.npy -v
  generate | gonio evaluate --server unix:/run/gonio.sock --material brushed --pairs - | sort -g)";

}  // namespace

void add_evaluate_options(CLI::App& command, EvaluateArguments& arguments) {
  arguments::set_footer(command, std::string(kMaterialHelp) + kInput + kFlagHelp + kExamples);
  add_material_options(command, arguments);
  const arguments::Option pairs =
      arguments::add_option(command, "--pairs", arguments.pairs,
                            "Pairs of directions from a file (see below); - is stdin")
          .type_name("FILE");
  arguments::add_option(command, "--grid", arguments.grid,
                        "In place of --pairs: a grid of angles (see below)")
      .type_name("SPEC")
      .excludes(pairs);
  arguments::add_flag(command, "--deg", arguments.degrees, "Angles are in degrees");
  arguments::add_flag(command, "--pdf", arguments.pdf,
                      "Also the densities with which wo would be sampled");
  arguments::add_flag(
      command, "--with-input", arguments.with_input,
      "Put the input's columns (directions or angles) before the results; CSV only");
  add_result_options(command, arguments, "pairs");
}

Result<Format> checked_format(const EvaluateArguments& arguments) {
  if (arguments.pairs.empty() && arguments.grid.empty()) {
    return bad_value("the input", "missing", "--pairs FILE or --grid SPEC");
  }
  const auto apart =
      check_standard_input({{"--material", arguments.material}, {"--pairs", arguments.pairs}});
  if (!apart) return apart.error();
  auto format = chosen_format(arguments);
  if (format && arguments.with_input && *format != Format::csv) {
    return bad_value("--with-input", "given", "with CSV results only");
  }
  return format;
}

}  // namespace gonio::cli
