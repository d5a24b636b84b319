#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "client/cli/arguments/common_arguments.h"
#include "client/cli/arguments/material_argument.h"
#include "client/cli/commands/commands.h"
#include "client/cli/output/check_outputs.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/report/assess_table.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr const char* kFooter = R"(
Places: for each place where reflectance models fail, the worst relative error of both precisions
against the formula in long double, the number of NaN, infinite and negative values and of values
where there should be none ("bad"), and what the same formula in naive arithmetic gives. Pairs have a
value for each channel.

Incidences: albedo by quadrature, what is gained and lost, how far the mean weight of samples is off,
the integral of the samples' density and the part of samples below the horizon (together 1), the
probability of the samples by chi-square, and the error of weight x pdf against f cos.

Checks and their limits:
  improper, stray   no bad values                 energy_gain     --max-gain
  error_fast        --max-error                   energy_loss     --max-loss
  error_reference   --max-reference-error         pdf_mass        --max-mass-error
  reciprocity       --max-reciprocity             weights         --max-weight-error
                                                  sampled_albedo  --max-deviation
                                                  distribution    --min-probability
and of a table, over all of its cells:
  missing           --max-missing                 holes           --max-holes
  missing_region    --max-missing-region          outlier         --max-outlier
  zeros             --max-zeros                   extreme         --max-extreme
Of samples a good material fails by chance in one of 1000 assessments.

Exit status 4 if a check failed.

Examples:
  gonio assess --material gold.json
  gonio assess --material gold.json --max-gain 0.01 --report gold-assessed.json || echo "not good enough")";

struct AssessArguments : CommonArguments {
  client::AssessOptions options;
  std::string report;  // empty: none
};

struct LimitOption {
  const char* name;
  std::optional<double> client::AssessLimits::*limit;
  const char* what;
};

constexpr std::array<LimitOption, 15> kLimits{{
    {"--max-error", &client::AssessLimits::error,
     "Relative error of the fast precision; the stated bound"},
    {"--max-reference-error", &client::AssessLimits::reference_error,
     "Relative error of the reference precision; the stated bound"},
    {"--max-reciprocity", &client::AssessLimits::reciprocity,
     "Relative difference when light and viewer change places; twice the stated bound"},
    {"--max-gain", &client::AssessLimits::gain,
     "Albedo above 1; 0.001, of a table for light within 87 degrees of the normal"},
    {"--max-loss", &client::AssessLimits::loss, "Albedo below 1, 0 to 1; 1, which allows any"},
    {"--max-mass-error", &client::AssessLimits::mass,
     "How far the density's integral and the mass below the horizon are from 1; 0.005"},
    {"--max-weight-error", &client::AssessLimits::weight_error,
     "Relative error of weight x pdf; the stated bound and four roundings"},
    {"--max-deviation", &client::AssessLimits::deviation,
     "Of albedos by samples, in standard errors; such that one of 1000 good materials fails"},
    {"--min-probability", &client::AssessLimits::probability,
     "Of the samples, by chi-square, 0 to 1; such that one of 1000 good materials fails"},
    {"--max-missing", &client::AssessLimits::missing,
     "Share of a table's cells without a measurement, to 80 degrees; 0.1"},
    {"--max-missing-region", &client::AssessLimits::missing_region,
     "The same in the worst range of ten cells of an angle; 0.5"},
    {"--max-zeros", &client::AssessLimits::zeros,
     "Share of a table's cells that hold 0, in the worst channel; 0.5"},
    {"--max-holes", &client::AssessLimits::holes,
     "Share of a table's cells that are masked: far darker than both sides; 0.001"},
    {"--max-outlier", &client::AssessLimits::outlier,
     "How many times as bright as what is about it a cell may be; 100"},
    {"--max-extreme", &client::AssessLimits::extreme,
     "f cos(theta_i) cos(theta_o) of a table's cells, in 1/sr; 100000"},
}};

Result<std::optional<OutputFile>> open_report(const std::string& file) {
  if (file.empty()) return std::optional<OutputFile>();
  auto output = OutputFile::open(file);
  if (!output) return output.error();
  return std::optional<OutputFile>(std::move(*output));
}

int run(AssessArguments& arguments) {
  const auto apart =
      check_outputs({{"--report", arguments.report}}, {{"--material", arguments.material}});
  if (!apart) return fail(apart.error());
  if (auto json = check_extension({"--report", arguments.report}, {".json"}); !json)
    return fail(json.error());
  auto material = read_material(arguments.material, arguments.connection.server.empty());
  if (!material) return fail(material.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  auto report = open_report(arguments.report);
  if (!report) return fail(report.error());
  arguments.options.instruction_set = arguments.evaluate_options().instruction_set;
  const auto assessment = connection->client.assess(*material, arguments.options);
  if (!assessment) return fail(assessment.error());
  if (*report) {
    if (auto written = (*report)->write_whole(assessment->json + "\n"); !written)
      return fail(written.error());
  }
  const auto shown = arguments.quiet ? Outcome(Ok{})
                                     : print_table(assess_table(*assessment, arguments.verbose),
                                                   arguments.report == "-");
  if (!shown) return fail(shown.error());
  return assessment->passed ? exit_ok : exit_bad_verdict;
}

void add_limits(CLI::App& command, client::AssessLimits& limits) {
  for (const LimitOption& option : kLimits) {
    arguments::add_option(command, option.name, limits.*option.limit, option.what).type_name("X");
  }
}

}  // namespace

Command add_assess_command(CLI::App& app) {
  auto arguments = std::make_shared<AssessArguments>();
  CLI::App& command = arguments::add_command(
      app, "assess", "Where a material fails: accuracy, energy, samples; a verdict");
  arguments::set_footer(command, std::string(kMaterialHelp) + kFooter);
  add_material_options(command, *arguments);
  arguments::remove_option(command, "--precision");  // both are looked at
  add_limits(command, arguments->options.limits);
  arguments::add_option(command, "--pairs", arguments->options.pairs,
                        "Pairs at each place, 1 to 1000000; 4000 if not given")
      .type_name("N")
      .range(1U, 1'000'000U);
  arguments::add_option(command, "--seed", arguments->options.seed,
                        "Of pairs and samples, 1 or more; 1 if not given")
      .type_name("N")
      .range(std::uint64_t{1}, std::uint64_t{1} << 62U);
  arguments::add_option(command, "--report,--json", arguments->report,
                        "Write all of it as JSON; - is stdout, the table then goes to stderr")
      .type_name("FILE");
  arguments::add_flag(command, "--quiet,-q", arguments->quiet, "No table");
  arguments::add_flag(command, "--verbose,-v", arguments->verbose,
                      "Say of each place what is special there, and where the worst error is");
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
