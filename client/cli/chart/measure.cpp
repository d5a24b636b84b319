#include "client/cli/chart/measure.h"

#include <unistd.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

#include "chart/chart.h"
#include "chart/example.h"
#include "client/cli/chart/wire.h"
#include "client/cli/comparison.h"
#include "client/cli/progress.h"
#include "engine/material_impl.h"
#include "server/server.h"

namespace gonio::cli {
namespace {

constexpr const char* kGenerated = "a generated paint";

chart::Options options_of(const ChartArguments& arguments) {
  chart::Options options;
  if (arguments.quick) {
    options.effort = {.repetitions = 5, .seconds = 0.001};
    options.pairs = 200;
  }
  return options;
}

Result<chart::Measured> read_measured_material(const ChartArguments& arguments) {
  if (arguments.data.empty()) {
    auto table = chart::example_table(1);
    return chart::Measured{kGenerated, fit::from_table(*table), table};
  }
  return read_chart_data(arguments.data, arguments.degrees);
}

// A server of this process on a socket, as near to a server on this machine as can be.
Result<chart::Table> measure_wire(const chart::Options& options) {
  const std::string address = "unix:" + (std::filesystem::temp_directory_path() /
                                         ("gonio-chart-" + std::to_string(::getpid())))
                                            .string();
  ServerOptions server_options;
  server_options.addresses = {address};
  const auto server = Server::start(server_options);
  if (!server) return server.error();
  return chart_wire(
      [&](const client::ClientOptions& client) { return client::Client::connect(address, client); },
      "a UNIX socket", options);
}

// A part's tables, by its name on the command line.
struct Part {
  const char* name;
  std::vector<std::function<Result<chart::Table>(const chart::Options&)>> tables;
};

std::vector<Part> all_parts(const std::optional<chart::Measured>& measured) {
  const auto angles = [](const chart::Options&) -> Result<chart::Table> {
    return chart::chart_fresnel_angles();
  };
  std::vector<Part> parts{{"models", {chart::chart_models}},
                          {"approximations", {chart::chart_fresnel, angles, chart::chart_printed}},
                          {"wire", {measure_wire, chart::chart_directions}},
                          {"sampling", {chart::chart_sampling}}};
  if (!measured) return parts;
  parts.push_back({"fits", {[&measured](const chart::Options& options) {
                     return chart::chart_fits(*measured, options);
                   }}});
  if (measured->table == nullptr) return parts;
  parts.push_back({"resolution", {[&measured](const chart::Options& options) {
                     return chart::chart_resolution(*measured, options);
                   }}});
  return parts;
}

}  // namespace

Result<Chart> measure(const ChartArguments& arguments) {
  std::optional<chart::Measured> measured;
  if (arguments.wants("fits") || arguments.wants("resolution")) {
    auto found = read_measured_material(arguments);
    if (!found) return found.error();
    measured.emplace(std::move(*found));
    if (measured->table == nullptr && !arguments.parts.empty() && arguments.wants("resolution")) {
      return bad_value("--data", "\"" + arguments.data + "\", which holds scattered pairs",
                       "a MERL .binary file for the part resolution");
    }
  }
  chart::Options options = options_of(arguments);
  Chart chart{chart::this_machine(), options.effort, measured ? measured->name : "", {}};
  Progress progress(!arguments.quiet, "parts");
  const std::vector<Part> parts = all_parts(measured);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!arguments.wants(parts[i].name)) continue;
    options.progress = [&progress, &parts, i](double done) {
      progress.show((static_cast<double>(i) + done) / static_cast<double>(parts.size()),
                    parts[i].name);
    };
    for (const auto& make : parts[i].tables) {
      auto table = make(options);
      if (!table) return table.error();
      chart.tables.push_back(std::move(*table));
    }
  }
  return chart;
}

}  // namespace gonio::cli
