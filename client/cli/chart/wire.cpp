#include "client/cli/chart/wire.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::cli {
namespace {

constexpr std::size_t kMillion = std::size_t{1} << 20U;

// One way to have pairs evaluated; more pairs than a chunk holds are a stream of chunks.
struct Way {
  const char* form;
  std::size_t pairs, chunk;
};
constexpr std::array kWays{
    Way{"pairs", 1, 65536},        Way{"pairs", 16, 65536},         Way{"pairs", 256, 65536},
    Way{"pairs", 4096, 65536},     Way{"pairs", 65536, 65536},      Way{"pairs", kMillion, 4096},
    Way{"pairs", kMillion, 16384}, Way{"pairs", kMillion, 65536},   Way{"float64", 4096, 65536},
    Way{"float64", 65536, 65536},  Way{"float64", kMillion, 65536}, Way{"grid", 4096, 65536},
    Way{"grid", 65536, 65536},     Way{"grid", kMillion, 65536}};

template <class T>
struct Arrays {
  std::vector<T> wi, wo, values;

  explicit Arrays(std::size_t pairs) : wi(3 * pairs), wo(3 * pairs), values(3 * pairs) {
    for (std::size_t i = 0; i < pairs; ++i) {
      // A golden-angle spiral over the hemisphere, and the same the other way round.
      const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(pairs);
      const double r = std::sqrt(1 - z * z), phi = 2.399963229728653 * static_cast<double>(i);
      set(&wi[3 * i], r * std::cos(phi), r * std::sin(phi), z);
      set(&wo[3 * i], z * std::sin(phi), z * std::cos(phi), r);
    }
  }
  static void set(T* to, double x, double y, double z) {
    to[0] = static_cast<T>(x), to[1] = static_cast<T>(y), to[2] = static_cast<T>(z);
  }
};

// Of a power of four pairs, both angles below the horizon by a little.
client::Grid grid_of(std::size_t pairs) {
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(pairs))));
  const auto inner = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(side))));
  const auto spread = [](std::size_t count, double range) {
    std::vector<double> angles(count);
    for (std::size_t i = 0; i < count; ++i)
      angles[i] = range * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    return angles;
  };
  client::Grid grid;
  grid.theta_i = spread(inner, std::numbers::pi / 2);
  grid.phi_i = {0};
  grid.theta_o = spread(side / inner, std::numbers::pi / 2);
  grid.phi_o = spread(pairs / side, 2 * std::numbers::pi);
  return grid;
}

using SharedClient = std::shared_ptr<const client::Client>;
using Failure = std::shared_ptr<std::optional<Error>>;

template <class T>
std::function<void()> pairs_runner(const SharedClient& client, const client::Material& material,
                                   std::size_t pairs, const Failure& failure) {
  const auto arrays = std::make_shared<Arrays<T>>(pairs);
  return [=] {
    const auto report = client->evaluate(material, std::span<const T>(arrays->wi),
                                         std::span<const T>(arrays->wo), arrays->values);
    if (!report && !*failure) *failure = report.error();
  };
}

std::function<void()> grid_runner(const SharedClient& client, const client::Material& material,
                                  std::size_t pairs, const Failure& failure) {
  const client::Grid grid = grid_of(pairs);
  const auto values = std::make_shared<std::vector<float>>(3 * pairs);
  return [=] {
    const auto report = client->evaluate(material, grid, *values);
    if (!report && !*failure) *failure = report.error();
  };
}

chart::Table empty_table(const std::string& transport) {
  chart::Table table{
      "wire",
      "The wire (" + transport + "): latency of a call against time a pair",
      {{"form", "", "pairs: float32 directions and values; float64: both; grid: angles"},
       {"call", "", "unary: one message each way; stream: of chunks, four on their way"},
       {"pairs", "1", "of a call or stream, three channels"},
       {"chunk", "1", "pairs a message"}},
      {}};
  chart::add_time_columns(table, "us", "us", "time of a call or stream on the clock");
  table.columns.push_back({"ns_a_pair", "ns", "the best repetition"});
  table.columns.push_back({"ns_a_pair_upper", "ns", "the upper quartile"});
  table.columns.push_back({"pairs_per_second", "1/s", "the best repetition"});
  return table;
}

std::vector<chart::Cell> row_of(const Way& way, const timing::Spread& seconds) {
  const auto pairs = static_cast<double>(way.pairs);
  std::vector<chart::Cell> row{std::string(way.form),
                               std::string(way.pairs > way.chunk ? "stream" : "unary"), pairs,
                               static_cast<double>(way.chunk)};
  chart::add_time_cells(row, scaled(seconds, 1e6));
  for (const double x :
       {1e9 * seconds.best / pairs, 1e9 * seconds.upper / pairs, pairs / seconds.best})
    row.emplace_back(x);
  return row;
}

}  // namespace

Result<chart::Table> chart_wire(
    const std::function<Result<client::Client>(const client::ClientOptions&)>& connect,
    const std::string& transport, const chart::Options& options) {
  const auto material = client::Material::from_json(
      R"({"model": "ashikhmin_shirley", "parameters": {"rd": [0.2, 0.1, 0.05], "rs": [0.9, 0.8, 0.5],
          "nu": 100, "nv": 1000}})");
  if (!material) return material.error();
  const auto failure = std::make_shared<std::optional<Error>>();
  std::vector<timing::Runner> runners;
  for (const Way& way : kWays) {
    auto connected = connect({.chunk_pairs = way.chunk});
    if (!connected) return connected.error();
    const auto client = std::make_shared<const client::Client>(std::move(*connected));
    const std::string form = way.form;
    runners.push_back({form == "grid" ? grid_runner(client, *material, way.pairs, failure)
                       : form == "float64"
                           ? pairs_runner<double>(client, *material, way.pairs, failure)
                           : pairs_runner<float>(client, *material, way.pairs, failure)});
    runners.back().run();
    if (*failure) return **failure;
  }
  timing::Effort effort = options.effort;
  effort.clock = timing::Clock::wall;
  const auto over = [&] { return failure->has_value() || (options.stop && options.stop()); };
  const auto seconds = timing::race(runners, effort, over);
  if (*failure) return **failure;
  if (over()) return Error{ErrorCode::cancelled, "the chart was cancelled", {}, {}, {}};
  chart::Table table = empty_table(transport);
  for (std::size_t i = 0; i < kWays.size(); ++i) table.rows.push_back(row_of(kWays[i], seconds[i]));
  chart::add_front(table, "us", "ns_a_pair", "");
  return table;
}

}  // namespace gonio::cli
