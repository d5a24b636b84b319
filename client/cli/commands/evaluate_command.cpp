#include <unistd.h>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/cli/arguments/evaluate_arguments.h"
#include "client/cli/arguments/grid_spec.h"
#include "client/cli/arguments/material_argument.h"
#include "client/cli/commands/commands.h"
#include "client/cli/input/degrees_hint.h"
#include "client/cli/input/input_columns.h"
#include "client/cli/input/pair_input.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/progress.h"
#include "client/cli/output/summary.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

// Where the directions come from: exactly one of the two.
template <class T>
struct Input {
  std::optional<GridSpec> grid;
  std::unique_ptr<PairInput<T>> pairs;

  static Result<Input> open(const EvaluateArguments& arguments) {
    Input input;
    if (!arguments.grid.empty()) {
      auto grid = parse_grid(arguments.grid, arguments.degrees);
      if (!grid) return grid.error();
      if (!arguments.degrees) hint_at_degrees(*grid);
      input.grid = std::move(grid).value();
      return input;
    }
    auto pairs =
        open_pairs<T>(InputKind::pairs, arguments.pairs, arguments.degrees, arguments.with_input);
    if (!pairs) return pairs.error();
    input.pairs = std::move(pairs).value();
    return input;
  }

  [[nodiscard]] std::optional<std::uint64_t> total() const {
    return grid ? grid->grid.size() : pairs->total();
  }

  [[nodiscard]] std::optional<double> progress(std::uint64_t done) const {
    if (!grid) return pairs->progress();
    return static_cast<double>(done) / static_cast<double>(*grid->grid.size());
  }

  [[nodiscard]] InputColumns<T> columns(bool wanted) const {
    if (!wanted) return {};
    return grid ? grid_columns<T>(*grid) : pair_columns<T>(*pairs);
  }
};

// One column a channel, and the pdf if there is one.
Table table_of(bool with_pdf) {
  Table table;
  table.is_mixed = with_pdf;
  table.columns = [with_pdf](int channels) {
    auto names = channel_names("f", channels);
    if (with_pdf) names.emplace_back("pdf");
    return names;
  };
  return table;
}

// The results as rows; `buffer` holds those that must be put together.
template <class T>
Rows<T> rows_of(const client::Chunk<T, T>& chunk, std::vector<T>& buffer) {
  Rows<T> rows{chunk.first, chunk.pairs, chunk.channels, chunk.values,
               chunk.flags, chunk.wi,    chunk.wo};
  if (chunk.pdf.empty()) return rows;
  buffer.clear();
  const auto channels = static_cast<std::size_t>(chunk.channels);
  for (std::size_t i = 0; i < chunk.pairs; ++i) {
    const auto values = chunk.values.subspan(i * channels, channels);
    buffer.insert(buffer.end(), values.begin(), values.end());
    buffer.push_back(chunk.pdf[i]);
  }
  rows.numbers = buffer;
  return rows;
}

template <class T>
Result<client::Report> evaluate(const client::Client& client, const client::Material& material,
                                const EvaluateArguments& arguments, const Input<T>& input,
                                ResultWriter<T>& writer) {
  // Not among the results of the same terminal.
  const bool on_terminal = arguments.output == "-" && ::isatty(STDOUT_FILENO) != 0;
  Progress progress(!arguments.quiet && !on_terminal, "pairs");
  std::vector<T> buffer;
  const client::ChunkSink<T, T> sink = [&](const client::Chunk<T, T>& chunk) {
    const std::uint64_t done = chunk.first + chunk.pairs;
    progress.update(done, input.progress(done));
    return writer.write(rows_of(chunk, buffer));
  };
  client::EvaluateOptions options = arguments.evaluate_options();
  options.pdf = arguments.pdf;
  if (input.grid) return client.evaluate_chunks<T>(material, input.grid->grid, sink, options);
  const client::PairSource<T> source = [&](std::span<T> wi, std::span<T> wo) {
    return input.pairs->read(wi, wo);
  };
  return client.evaluate_chunks<T, T>(material, source, sink, options);
}

template <class T>
int run(const EvaluateArguments& arguments) {
  auto format = checked_format(arguments);
  if (!format) return fail(format.error());
  auto material = read_material(arguments.material, arguments.connection.server.empty());
  if (!material) return fail(material.error());
  auto input = Input<T>::open(arguments);
  if (!input) return fail(input.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  auto output = OutputFile::open(arguments.output, *format == Format::npy && !input->total());
  if (!output) return fail(output.error());

  const auto start = std::chrono::steady_clock::now();
  const auto writer = make_writer<T>(*format, *output, table_of(arguments.pdf), input->total(),
                                     input->columns(arguments.with_input));
  auto result = evaluate(connection->client, *material, arguments, *input, *writer);
  Outcome written = result ? writer->finish(*result) : Outcome(result.error());
  if (written) written = output->commit();
  if (output->reader_gone()) return exit_ok;
  if (!written) return fail(written.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  print_summary(*result, "pairs", taken.count(), arguments.quiet, arguments.verbose);
  return exit_ok;
}

}  // namespace

Command add_evaluate_command(CLI::App& app) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App& command = arguments::add_command(
      app, "evaluate", "Evaluate a material for pairs of directions or a grid");
  add_evaluate_options(command, *arguments);
  return {&command, [arguments] {
            return arguments->is_reference() ? run<double>(*arguments) : run<float>(*arguments);
          }};
}

}  // namespace gonio::cli
