#include "client/cli/chart/measure.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "chart/parts.h"
#include "client/cli/chart/wire.h"
#include "client/cli/compare/comparison.h"
#include "client/cli/output/progress.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

chart::Options options_of(const ChartArguments& arguments) {
  chart::Options options;
  if (arguments.quick) {
    options.effort = {.repetitions = 5, .seconds = 0.001};
    options.pairs = 200;
  }
  return options;
}

// What the core measures of them.
std::vector<std::string> core_parts(const ChartArguments& arguments) {
  std::vector<std::string> parts;
  for (const chart::Part& part : chart::all_parts()) {
    if (arguments.wants(name_of(part))) parts.emplace_back(part.name);
  }
  return parts;
}

// Resolution that is not asked for by name is left out where there is no table.
void leave_out_resolution(const ChartArguments& arguments, std::vector<std::string>& parts) {
  if (arguments.parts.empty()) std::erase(parts, "resolution");
}

Outcome measure_here(const ChartArguments& arguments, Progress& progress, Chart& chart) {
  chart::Wanted wanted{core_parts(arguments), std::nullopt};
  if (!arguments.data.empty() && chart::needs_material(wanted.parts)) {
    auto measured = read_chart_data(arguments.data, arguments.degrees);
    if (!measured) return measured.error();
    if (measured->table == nullptr) leave_out_resolution(arguments, wanted.parts);
    wanted.measured.emplace(std::move(*measured));
  }
  chart::Options options = options_of(arguments);
  const double deadline = arguments.connection.deadline;
  const double end = timing::now(timing::Clock::wall) + deadline;
  if (deadline > 0) options.stop = [end] { return timing::now(timing::Clock::wall) > end; };
  auto tables = chart::measure(wanted, options, [&](std::string_view part, double done) {
    progress.show(done, std::string(part));
  });
  if (!tables && tables.error().code == ErrorCode::cancelled) {
    return Error{ErrorCode::deadline_exceeded,
                 "the chart was not done within --deadline " + std::to_string(deadline) + " s",
                 {},
                 {},
                 {}};
  }
  if (!tables) return tables.error();
  chart.machine = chart::this_machine();
  chart.tables = std::move(*tables);
  return Ok{};
}

Outcome measure_there(const client::Client& client, const ChartArguments& arguments,
                      Progress& progress, Chart& chart) {
  const chart::Options wanted = options_of(arguments);
  client::ChartOptions options;
  options.parts = core_parts(arguments);
  options.repetitions = static_cast<unsigned>(wanted.effort.repetitions);
  options.seconds = wanted.effort.seconds;
  options.pairs_at_a_place = static_cast<unsigned>(wanted.pairs);
  std::optional<MeasuredInput> input;
  if (!arguments.data.empty() && chart::needs_material(options.parts)) {
    auto read = read_data(arguments.data, false, arguments.degrees);
    if (!read) return read.error();
    input.emplace(std::move(*read));
    if (!input->measured) leave_out_resolution(arguments, options.parts);
    options.data = input->data();
  }
  client::ChartWatch watch;
  watch.progress = [&](const client::ChartProgress& at) { progress.show(at.done, at.stage); };
  auto measured = client.chart(options, watch);
  if (!measured) return measured.error();
  chart.machine = measured->machine;
  chart.tables = std::move(measured->tables);
  return Ok{};
}

// Without a server's address, one of this process on a socket, as near to one on this machine as
// can be.
Result<chart::Table> measure_wire(const ChartArguments& arguments) {
  ConnectionOptions connection = arguments.connection;
  std::optional<EmbeddedServer> own;
  if (connection.server.empty()) {
    const std::string name = "gonio-chart-" + std::to_string(::getpid());
    connection.server = "unix:" + (fs::temp_directory_path() / name).string();
    auto started = EmbeddedServer::start_at(connection.server, connection.threads);
    if (!started) return started.error();
    own.emplace(std::move(*started));
  }
  return chart_wire(
      [&](client::ClientOptions options) {
        const std::chrono::duration<double> deadline(connection.deadline);
        options.deadline = std::chrono::ceil<std::chrono::milliseconds>(deadline);
        return client::Client::connect(connection.server, options);
      },
      own ? "a UNIX socket" : connection.server, options_of(arguments));
}

}  // namespace

Result<Chart> measure(const ChartArguments& arguments) {
  Chart chart;
  chart.effort = options_of(arguments).effort;
  chart.material = arguments.data;
  Progress progress(!arguments.quiet, "parts");
  if (arguments.connection.server.empty()) {
    if (auto done = measure_here(arguments, progress, chart); !done) return done.error();
  } else {
    auto connection = Connection::open(arguments.connection);
    if (!connection) return connection.error();
    if (auto done = measure_there(connection->client, arguments, progress, chart); !done)
      return done.error();
  }
  if (!arguments.wants("wire")) return chart;
  progress.show(1, "wire");
  auto wire = measure_wire(arguments);
  if (!wire) return wire.error();
  chart.tables.push_back(std::move(*wire));
  return chart;
}

}  // namespace gonio::cli
