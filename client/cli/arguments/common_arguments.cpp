#include "client/cli/arguments/common_arguments.h"

#include <unistd.h>

#include "client/cli/output/check_outputs.h"
#include "server/arguments/options.h"
#include "server/materials/preset_material.h"

namespace gonio::cli {

const char* const kMaterialHelp = R"(
Material M, in this order:
  {...}                 inline JSON: {"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29], "alpha_x": 0.2}},
                        a sum {"diffuse": {...}, "specular": [{...}, ...]}, or {"name": "stored"}
  -                     such JSON on standard input
  FILE.json, DIR/FILE   a file with such JSON; @FILE too, whatever its name
  FILE.binary           a measured material in MERL's format (not with --server)
  NAME                  a file of that name that holds a material; else a material that the server holds
                        ('gonio models' lists them); else a substance ('gonio models --presets'): a
                        surface of GGX microfacets of it, with the default roughness
Beside "model", "diffuse", "specular" or "name", "rotation": DEG turns the tangents about the normal, -180 to
180 degrees, counter-clockwise seen from above.
)";

const char* const kFlagHelp =
    R"(1 not unit length, 2 not finite, 4 zero vector, 8 wi below the horizon, 16 wo below the horizon,
32 outside the measured data. 128 is no error: the value stands, and some of the table's cells that it
is from are holes, masked or not measured.)";

client::EvaluateOptions CommonArguments::evaluate_options() const {
  client::EvaluateOptions options;
  options.instruction_set = client::instruction_set_of(isa).value();
  return options;
}

void add_material_option(CLI::App& command, std::string& material, const std::string& what) {
  arguments::add_option(command, "--material,-m", material, what)
      .type_name("M")
      .required()
      .suggest(server::preset_names());
}

void add_material_options(CLI::App& command, CommonArguments& arguments) {
  add_material_option(command, arguments.material, "What to evaluate (see below)");
  arguments::add_option(command, "--precision", arguments.precision,
                        "fast (float32, the default) or reference (float64)")
      .type_name("P")
      .one_of({"fast", "reference"});
  arguments::add_option(command, "--isa", arguments.isa,
                        "Instruction set: auto (the default), baseline, avx2, avx512")
      .type_name("SET")
      .one_of({"auto", "baseline", "avx2", "avx512"});
  add_connection_options(command, arguments.connection);
}

void add_result_options(CLI::App& command, CommonArguments& arguments, const std::string& items) {
  arguments::add_option(command, "--format", arguments.format,
                        "csv, json or npy; else by OUT's extension, else csv")
      .type_name("F")
      .one_of({"csv", "json", "npy"});
  arguments::add_option(command, "-o,--output", arguments.output,
                        "Where the results go; - is stdout, the default")
      .type_name("OUT");
  arguments::add_flag(command, "--quiet,-q", arguments.quiet,
                      "No progress bar and no summary of flagged " + items);
  arguments::add_flag(command, "--verbose,-v", arguments.verbose,
                      "Report time, speed, instruction set and accuracy on stderr");
}

Result<Format> chosen_format(const CommonArguments& arguments) {
  auto format = format_named(arguments.format);
  if (!format) {
    const auto known = check_extension({"-o", arguments.output}, {".csv", ".json", ".npy"},
                                       "; or any with --format csv, json or npy");
    if (!known) return known.error();
    format = format_of_file(arguments.output);
  }
  const Format chosen = format.value_or(Format::csv);
  if (chosen == Format::npy && arguments.output == "-" && ::isatty(STDOUT_FILENO) != 0) {
    return bad_value("--format", "npy, for a terminal", "npy with -o FILE or a pipe");
  }
  return chosen;
}

}  // namespace gonio::cli
