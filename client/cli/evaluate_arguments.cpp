#include "client/cli/evaluate_arguments.h"

#include <unistd.h>

#include <CLI/CLI.hpp>

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
Material M, in this order:
  {...}                 inline JSON: {"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29], "alpha_x": 0.2}},
                        a sum {"diffuse": {...}, "specular": [{...}, ...]}, or {"name": "stored"}
  FILE.json, DIR/FILE   a file with such JSON
  FILE.binary           a measured material in MERL's format (not with --server)
  NAME                  a material that the server holds ('gonio models' lists them)

Pairs: CSV with the header wi_x,wi_y,wi_z,wo_x,wo_y,wo_z (directions away from the surface, whose
normal is 0,0,1; lengths within 0.001 of 1 are corrected) or theta_i,phi_i,theta_o,phi_o (angles in
radians, or degrees with --deg; theta from the normal). Other columns are ignored. Or an NPY file:
float32 or float64, N x 6, columns as in the first header.

Grid: AXIS=ANGLES,AXIS=ANGLES,... with the axes theta_i, phi_i, theta_o, phi_o (the last the fastest;
one that is not given is 0), or the half-angle axes theta_h, theta_d, phi_d. ANGLES is
START:STOP:COUNT with both ends included, or a list such as 0/15/40. At most 1000000000 pairs.

Results: the BRDF's values in 1/sr, without a cosine.
  csv   f_0,f_1,...,flags: one column a channel (9 digits for fast, 17 for reference) and the flags
  npy   N x channels, float32 for fast, float64 for reference; the flags are summed up on stderr
  json  {"channels": C, "values": [[f_0, ...], ...], "flags": [...], "report": {...}}
A pair that cannot be evaluated has the value 0 and flags, the sum of: 1 not unit length, 2 not
finite, 4 zero vector, 8 wi below the horizon, 16 wo below the horizon, 32 outside the measured data.

Examples:
  gonio evaluate --material copper.json --grid theta_i=0:80:9,theta_o=0:90:91,phi_o=0/180 --deg \
      --with-input > plane.csv
  gonio evaluate --material gold.binary --pairs pairs.npy -o values.npy -v
  generate | gonio evaluate --server unix:/run/gonio.sock --material brushed --pairs - | sort -g)";

}  // namespace

void add_evaluate_options(CLI::App& command, EvaluateArguments& arguments) {
  command.footer(kFooter);
  command.add_option("--material,-m", arguments.material, "What to evaluate (see below)")
      ->type_name("M")
      ->required();
  auto* pairs = command.add_option("--pairs", arguments.pairs,
                                   "Pairs of directions from a file (see below); - is stdin");
  pairs->type_name("FILE");
  command.add_option("--grid", arguments.grid, "In place of --pairs: a grid of angles (see below)")
      ->type_name("SPEC")
      ->excludes(pairs);
  command
      .add_option("--precision", arguments.precision,
                  "fast (float32, the default) or reference (float64)")
      ->type_name("P")
      ->check(CLI::IsMember({"fast", "reference"}).description(""));
  command
      .add_option("--isa", arguments.isa,
                  "Instruction set: auto (the default), baseline, avx2, avx512")
      ->type_name("SET")
      ->check(CLI::IsMember({"auto", "baseline", "avx2", "avx512"}).description(""));
  command.add_flag("--deg", arguments.degrees, "Angles are in degrees");
  command
      .add_option("--format", arguments.format,
                  "csv, json or npy; else by OUT's extension, else csv")
      ->type_name("F")
      ->check(CLI::IsMember({"csv", "json", "npy"}).description(""));
  command
      .add_option("-o,--output", arguments.output, "Where the results go; - is stdout, the default")
      ->type_name("OUT");
  command.add_flag("--with-input", arguments.with_input,
                   "Put the input's columns (directions or angles) before the results; CSV only");
  add_connection_options(command, arguments.connection);
  command.add_flag("--quiet,-q", arguments.quiet,
                   "No progress bar and no summary of flagged pairs");
  command.add_flag("--verbose,-v", arguments.verbose,
                   "Report time, speed, instruction set and accuracy on stderr");
}

Result<Format> chosen_format(const EvaluateArguments& arguments) {
  if (arguments.pairs.empty() && arguments.grid.empty()) {
    return bad_value("the input", "missing", "--pairs FILE or --grid SPEC");
  }
  auto format = format_named(arguments.format);
  if (!format) format = format_of_file(arguments.output);
  const Format chosen = format.value_or(Format::csv);
  if (arguments.with_input && chosen != Format::csv) {
    return bad_value("--with-input", "given", "with CSV results only");
  }
  if (chosen == Format::npy && arguments.output == "-" && ::isatty(STDOUT_FILENO) != 0) {
    return bad_value("--format", "npy, for a terminal", "npy with -o FILE or a pipe");
  }
  return chosen;
}

}  // namespace gonio::cli
