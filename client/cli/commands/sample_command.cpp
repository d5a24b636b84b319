#include <unistd.h>

#include <chrono>
#include <memory>
#include <vector>

#include "client/cli/arguments/common_arguments.h"
#include "client/cli/arguments/material_argument.h"
#include "client/cli/arguments/number_arguments.h"
#include "client/cli/arguments/wi_argument.h"
#include "client/cli/commands/commands.h"
#include "client/cli/output/check_outputs.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/progress.h"
#include "client/cli/output/summary.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr const char* kResults = R"(
Results: N samples of the first wi, then of the next. A sample is a direction wo to the viewer, its
density per steradian and a weight f cos(theta_o) / pdf in each channel; the mean weight is the albedo.
  csv   wo_x,wo_y,wo_z,pdf,w_0,...,flags: the weights are the w
  npy   samples x (4 + channels), columns as in csv but for the flags, which are summed up on stderr
  json  {"channels": C, "columns": [...], "samples": [[wo_x, ...], ...], "flags": [...], "report": {...}}
Flags are the sum of: )";

constexpr const char* kExamples = R"(.
A sample that falls below the horizon (16) has the weight 0 and counts: a mean over all is right.
The same seed gives the same samples, anywhere. At most 1000000000 of them.

Examples:
  gonio sample --material gold.json --wi 0.6,0,0.8 --count 1000 --seed 7 > samples.csv
  gonio sample --material gold.json --wi-file wi.csv --count 256 --sequence sobol -o samples.npy)";

struct SampleArguments : CommonArguments {
  WiArguments wi;
  NumberArguments numbers;
  bool with_input = false;
};

Table sample_table(bool with_input) {
  Table table;
  table.is_mixed = table.of_samples = true;
  table.columns = [with_input](int channels) {
    std::vector<std::string> names = {"wo_x", "wo_y", "wo_z", "pdf"};
    if (with_input) names.insert(names.begin(), {"wi_x", "wi_y", "wi_z"});
    for (const std::string& name : channel_names("w", channels)) names.push_back(name);
    return names;
  };
  return table;
}

template <class T>
Rows<T> rows_of(const client::SampleChunk<T>& chunk, bool with_input, std::vector<T>& buffer) {
  const auto channels = static_cast<std::size_t>(chunk.channels);
  const auto append = [&](std::span<const T> numbers) {
    buffer.insert(buffer.end(), numbers.begin(), numbers.end());
  };
  buffer.clear();
  for (std::size_t i = 0; i < chunk.samples; ++i) {
    if (with_input) append(chunk.wi_of(i));
    append(chunk.wo.subspan(3 * i, 3));
    append(chunk.pdf.subspan(i, 1));
    append(chunk.weights.subspan(i * channels, channels));
  }
  return {chunk.first, chunk.samples, chunk.channels, buffer, chunk.flags, {}, {}};
}

template <class T>
Result<client::Report> sample(const client::Client& client, const client::Material& material,
                              const SampleArguments& arguments, WiInput<T>& input,
                              ResultWriter<T>& writer) {
  const bool on_terminal = arguments.output == "-" && ::isatty(STDOUT_FILENO) != 0;
  Progress progress(!arguments.quiet && !on_terminal, "samples");
  std::vector<T> buffer;
  const client::SampleSink<T> sink = [&](const client::SampleChunk<T>& chunk) {
    progress.update(chunk.first + chunk.samples, input.progress());
    return writer.write(rows_of(chunk, arguments.with_input, buffer));
  };
  std::uint64_t directions = 0;
  const client::DirectionSource<T> source = [&](std::span<T> wi) -> Result<std::size_t> {
    auto given = input.read(wi);
    if (!given) return given;
    directions += *given;
    if (auto fits = check_count(arguments.numbers, 1, directions); !fits) return fits.error();
    return given;
  };
  return client.sample_chunks<T>(material, source, arguments.numbers.per_wi(),
                                 arguments.numbers.source(), sink, arguments.evaluate_options());
}

template <class T>
int run(const SampleArguments& arguments) {
  auto format = chosen_format(arguments);
  if (!format) return fail(format.error());
  const auto apart = check_standard_input(
      {{"--material", arguments.material}, {"--wi-file", arguments.wi.wi_file}});
  if (!apart) return fail(apart.error());
  auto input = WiInput<T>::open(arguments.wi);
  if (!input) return fail(input.error());
  auto counted = check_count(arguments.numbers, 1, input->total().value_or(1));
  if (!counted) return fail(counted.error());
  auto material = read_material(arguments.material, arguments.connection.server.empty());
  if (!material) return fail(material.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  const auto directions = input->total();
  auto output = OutputFile::open(arguments.output, *format == Format::npy && !directions);
  if (!output) return fail(output.error());

  const auto start = std::chrono::steady_clock::now();
  std::optional<std::uint64_t> rows;
  if (directions) rows = *directions * arguments.numbers.per_wi();
  const auto writer =
      make_writer<T>(*format, *output, sample_table(arguments.with_input), rows, {});
  auto result = sample<T>(connection->client, *material, arguments, *input, *writer);
  Outcome written = result ? writer->finish(*result) : Outcome(result.error());
  if (written) written = output->commit();
  if (output->reader_gone()) return exit_ok;
  if (!written) return fail(written.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  print_summary(*result, "samples", taken.count(), arguments.quiet, arguments.verbose);
  return exit_ok;
}

}  // namespace

Command add_sample_command(CLI::App& app) {
  auto arguments = std::make_shared<SampleArguments>();
  CLI::App& command = arguments::add_command(app, "sample", "Draw directions for a material");
  arguments::set_footer(command,
                        std::string(kMaterialHelp) + kWiHelp + kResults + kFlagHelp + kExamples);
  add_material_options(command, *arguments);
  add_wi_options(command, arguments->wi);
  add_number_options(command, arguments->numbers);
  arguments::find_option(command, "--count").required();
  arguments::add_flag(command, "--with-input", arguments->with_input, "Put wi before each sample");
  add_result_options(command, *arguments, "samples");
  return {&command, [arguments] {
            return arguments->is_reference() ? run<double>(*arguments) : run<float>(*arguments);
          }};
}

}  // namespace gonio::cli
