#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "client/cli/arguments/common_arguments.h"
#include "client/cli/arguments/material_argument.h"
#include "client/cli/arguments/number_arguments.h"
#include "client/cli/arguments/wi_argument.h"
#include "client/cli/commands/commands.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/output/check_outputs.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/summary.h"
#include "client/cli/output/terminal.h"
#include "client/cli/report/albedo_table.h"
#include "gonio/engine/grid.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr std::int64_t kDefaultCount = 65536;

constexpr const char* kFooter = R"(
Angles: --theta 0,30,60, in degrees from the normal, in the plane of u and the normal (--phi turns it).

Results: for each wi the albedo (directional-hemispherical reflectance) of each channel, its standard
error, and the fraction of samples that fell below the horizon. With --sequence sobol the error is
usually much smaller than the one that is printed, which takes the samples to be independent.

Examples:
  gonio albedo --material gold.json --theta 0,30,60,85
  gonio albedo --material gold.json --wi-file wi.csv --count 1000000 --format json -o albedo.json)";

struct AlbedoArguments : CommonArguments {
  WiArguments wi;
  NumberArguments numbers{kDefaultCount};
  std::string theta;
  double phi = 0;
  bool json = false;
};

enum class Form : std::uint8_t { text, json };

// "0,30,60" in degrees.
template <class T>
Result<std::vector<T>> directions_at(const std::string& thetas, double phi) {
  constexpr double kDegree = std::numbers::pi / 180;
  std::vector<T> wi;
  std::string_view rest = thetas;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    const auto theta = parse_number<double>(rest.substr(0, comma));
    if (!theta || !(*theta >= 0 && *theta < 90)) {
      return bad_value("--theta", "'" + std::string(rest.substr(0, comma)) + "'",
                       "angles from 0 to below 90 degrees, separated by commas");
    }
    rest.remove_prefix(more ? comma + 1 : rest.size());
    wi.resize(wi.size() + 3);
    direction_at(*theta * kDegree, phi * kDegree, &wi[wi.size() - 3]);
  }
  return wi;
}

// All of them: an albedo's samples are many times its wi.
template <class T>
Result<std::vector<T>> directions_of(const WiArguments& arguments) {
  constexpr std::size_t kStep = 4096;
  auto input = WiInput<T>::open(arguments);
  if (!input) return input.error();
  std::vector<T> wi;
  for (;;) {
    const std::size_t old = wi.size();
    wi.resize(old + 3 * kStep);
    auto given = input->read(std::span(wi).subspan(old));
    if (!given) return given.error();
    wi.resize(old + 3 * *given);
    if (*given == 0) return wi;
  }
}

template <class T>
Result<std::vector<T>> read_directions(const AlbedoArguments& arguments) {
  const bool other = !arguments.wi.wi.empty() || !arguments.wi.wi_file.empty();
  if (arguments.theta.empty() == !other) {
    return bad_value("the input", other ? "given twice" : "missing",
                     "--theta ANGLES, --wi X,Y,Z or --wi-file FILE");
  }
  return other ? directions_of<T>(arguments.wi) : directions_at<T>(arguments.theta, arguments.phi);
}

Result<Form> text_or_json(const AlbedoArguments& arguments) {
  if (!arguments.format.empty() && arguments.json)
    return bad_value("--json", "given beside --format", "one of the two");
  if (arguments.json || arguments.format == "json") return Form::json;
  if (!arguments.format.empty()) return Form::text;
  const auto known = check_extension({"-o", arguments.output}, {".json", ".txt"},
                                     "; or any with --format text or json");
  if (!known) return known.error();
  return extension_of(arguments.output) == ".json" ? Form::json : Form::text;
}

template <class T>
int run(const AlbedoArguments& arguments) {
  const auto form = text_or_json(arguments);
  if (!form) return fail(form.error());
  auto wi = read_directions<T>(arguments);
  if (!wi) return fail(wi.error());
  auto counted = check_count(arguments.numbers, 2, wi->size() / 3);
  if (!counted) return fail(counted.error());
  const auto apart = check_standard_input(
      {{"--material", arguments.material}, {"--wi-file", arguments.wi.wi_file}});
  if (!apart) return fail(apart.error());
  auto material = read_material(arguments.material, arguments.connection.server.empty());
  if (!material) return fail(material.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  auto output = OutputFile::open(arguments.output);
  if (!output) return fail(output.error());

  const auto start = std::chrono::steady_clock::now();
  auto albedos =
      connection->client.integrate(*material, std::span<const T>(*wi), arguments.numbers.per_wi(),
                                   arguments.numbers.source(), arguments.evaluate_options());
  if (!albedos) return fail(albedos.error());
  const std::vector<double> directions(wi->begin(), wi->end());
  Outcome written = output->write(*form == Form::json ? albedo_json(directions, *albedos)
                                                      : albedo_text(directions, *albedos));
  if (written) written = output->commit();
  if (output->reader_gone()) return exit_ok;
  if (!written) return fail(written.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (arguments.verbose) {
    print_note(report_line(albedos->report, "samples", taken.count()));
  }
  return exit_ok;
}

}  // namespace

Command add_albedo_command(CLI::App& app) {
  auto arguments = std::make_shared<AlbedoArguments>();
  CLI::App& command =
      arguments::add_command(app, "albedo", "How much a material reflects, by sampling");
  arguments::set_footer(command, std::string(kMaterialHelp) + kWiHelp + kFooter);
  add_material_options(command, *arguments);
  arguments::add_option(command, "--theta", arguments->theta, "Angles of incidence in degrees")
      .type_name("ANGLES");
  arguments::add_option(command, "--phi", arguments->phi,
                        "The azimuth of all --theta in degrees; 0 is along u")
      .type_name("ANGLE")
      .range(-360.0, 360.0);
  add_wi_options(command, arguments->wi);
  add_number_options(command, arguments->numbers);
  arguments::find_option(command, "--count").default_value(kDefaultCount);
  arguments::add_flag(command, "--json", arguments->json, "Print JSON in place of a table");
  arguments::add_option(command, "--format", arguments->format,
                        "text or json (as --json); else by OUT's extension, else text")
      .type_name("F")
      .one_of({"text", "json"});
  arguments::add_option(command, "-o,--output", arguments->output,
                        "Where the results go; - is stdout, the default")
      .type_name("OUT");
  arguments::add_flag(command, "--verbose,-v", arguments->verbose,
                      "Report time, speed, instruction set and accuracy on stderr");
  return {&command, [arguments] {
            return arguments->is_reference() ? run<double>(*arguments) : run<float>(*arguments);
          }};
}

}  // namespace gonio::cli
