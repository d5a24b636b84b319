#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "client/cli/arguments/fit_arguments.h"
#include "client/cli/arguments/fit_forms.h"
#include "client/cli/commands/commands.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/input/measured_input.h"
#include "client/cli/output/check_outputs.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/json.h"
#include "client/cli/output/output_file.h"
#include "client/cli/output/progress.h"
#include "client/cli/output/terminal.h"
#include "client/cli/report/fit_page.h"
#include "client/cli/report/fit_table.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

// How much of a fit is done when a stage begins, from the time that stages take.
double part_before(const std::string& stage) {
  constexpr std::array<std::pair<std::string_view, double>, 4> kStages{
      {{"scan", 0.1}, {"starts", 0.3}, {"fit", 0.5}, {"polish", 0.7}}};
  for (const auto& [name, part] : kStages) {
    if (name == stage) return part;
  }
  return 0;
}

Result<std::vector<NamedFit>> fit_all(const client::Client& client, const client::FitData& data,
                                      const std::vector<FitForm>& forms,
                                      const FitArguments& arguments) {
  Progress progress(!arguments.quiet, "fits");
  std::vector<NamedFit> fits;
  for (const FitForm& form : forms) {
    const auto done = static_cast<double>(fits.size()), count = static_cast<double>(forms.size());
    client::FitWatch watch;
    watch.progress = [&](const client::FitProgress& at) {
      char best[32];
      std::snprintf(best, sizeof(best), "%.4g", at.best);
      progress.show((done + part_before(at.stage)) / count,
                    form.name + ": " + at.stage + (at.best > 0 ? std::string(", ") + best : ""));
    };
    auto result = client.fit(data, form.material, fit_options(arguments), watch);
    if (!result) return result.error();
    fits.push_back({form.name, std::move(*result)});
  }
  return fits;
}

// The least objective at the end, of those that did not fail. Null if all did.
const NamedFit* best_of(const std::vector<NamedFit>& fits) {
  const NamedFit* best = nullptr;
  for (const NamedFit& fit : fits) {
    const client::FitCertificate& certificate = fit.result.certificate;
    if (certificate.verdict == client::Verdict::failed || certificate.stages.empty()) continue;
    if (best == nullptr ||
        certificate.stages.back().objective < best->result.certificate.stages.back().objective) {
      best = &fit;
    }
  }
  return best;
}

std::string report_of(const std::vector<NamedFit>& fits, const FitArguments& arguments,
                      const MeasuredInput& input) {
  std::string text = "{\"data\": " + json_string(arguments.data) +
                     ", \"raised_to_zero\": " + std::to_string(input.raised) + ",\n\"fits\": [";
  const char* separator = "\n";
  for (const NamedFit& fit : fits) {
    text += separator + ("{\"model\": " + json_string(fit.name)) + ", \"verdict\": \"" +
            std::string(name_of(fit.result.certificate.verdict)) +
            "\", \"result\": " + fit.result.json + "}";
    separator = ",\n";
  }
  return text + "]}\n";
}

// Where the results go. Opened before the fit: what cannot be written shows before the work.
struct Outputs {
  std::optional<OutputFile> material;
  std::vector<OutputFile> reports;
  std::vector<bool> pages;  // which of them are for people
};

Result<Outputs> open_outputs(const FitArguments& arguments) {
  std::vector<NamedFile> files{{"--output", arguments.output}};
  for (const std::string& report : arguments.reports) files.push_back({"--report", report});
  if (auto apart = check_outputs(files, {{"--data", arguments.data}}); !apart) return apart.error();
  if (auto json = check_extension(files.front(), {".json"}); !json) return json.error();
  for (const std::string& report : arguments.reports) {
    if (auto known = check_extension({"--report", report}, {".json", ".md"}); !known)
      return known.error();
  }
  Outputs outputs;
  if (!arguments.output.empty()) {
    auto file = OutputFile::open(arguments.output);
    if (!file) return file.error();
    outputs.material.emplace(std::move(*file));
  }
  for (const std::string& report : arguments.reports) {
    auto file = OutputFile::open(report);
    if (!file) return file.error();
    outputs.reports.push_back(std::move(*file));
    outputs.pages.push_back(extension_of(report) == ".md");
  }
  return outputs;
}

std::string page_of(const std::vector<NamedFit>& fits, const FitArguments& arguments,
                    const MeasuredInput& input) {
  std::string text = shown_lines(fit_page(fits, arguments));
  if (input.raised > 0) text += "\nOf the data: " + raised_text(input) + ".\n";
  return text;
}

// The reports in any case, the material if there is one.
Outcome write_all(Outputs& outputs, const std::vector<NamedFit>& fits, const NamedFit* best,
                  const FitArguments& arguments, const MeasuredInput& input) {
  for (std::size_t i = 0; i < outputs.reports.size(); ++i) {
    const auto written = outputs.reports[i].write_whole(
        outputs.pages[i] ? page_of(fits, arguments, input) : report_of(fits, arguments, input));
    if (!written) return written;
  }
  if (!outputs.material || best == nullptr) return Ok{};
  return outputs.material->write_whole(best->result.material.to_json() + "\n");
}

// Also where --quiet leaves no table that says it.
Error none_fits(const std::vector<NamedFit>& fits) {
  const bool empty = std::all_of(fits.begin(), fits.end(), [](const NamedFit& fit) {
    return fit.result.certificate.pairs == 0;
  });
  std::string text = "every fit failed";
  for (const NamedFit& fit : fits) text += "; " + fit.name + ": " + fit.result.certificate.reason;
  // Data without a usable pair are wrong input, as for every command that reads them.
  return {empty ? ErrorCode::invalid_argument : ErrorCode::internal, text, {}, {}, {}};
}

int run(const FitArguments& arguments) {
  if (auto angles = check_angles(arguments); !angles) return fail(angles.error());
  auto input = read_data(arguments.data, arguments.connection.server.empty(), arguments.degrees);
  if (!input) return fail(input.error());
  if (input->raised > 0 && !arguments.quiet)
    print_note(arguments.data + ": " + raised_text(*input));
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  const auto catalogue = connection->client.list_models();
  if (!catalogue) return fail(catalogue.error());
  const auto forms = fit_forms(arguments, *catalogue);
  if (!forms) return fail(forms.error());
  auto outputs = open_outputs(arguments);
  if (!outputs) return fail(outputs.error());

  const auto fits = fit_all(connection->client, input->data(), *forms, arguments);
  if (!fits) return fail(fits.error());
  const NamedFit* best = best_of(*fits);
  if (auto written = write_all(*outputs, *fits, best, arguments, *input); !written)
    return fail(written.error());
  const bool taken = arguments.output == "-" ||
                     std::count(arguments.reports.begin(), arguments.reports.end(), "-") > 0;
  const auto shown = arguments.quiet ? Outcome(Ok{}) : print_table(fit_table(*fits), taken);
  if (!shown) return fail(shown.error());
  return best != nullptr ? exit_ok : fail(none_fits(*fits));
}

}  // namespace

Command add_fit_command(CLI::App& app) {
  auto arguments = std::make_shared<FitArguments>();
  CLI::App& command = arguments::add_command(app, "fit", "Fit models to measured reflectance");
  add_fit_options(command, *arguments);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
