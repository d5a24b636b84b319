#include "select/scene.h"

#include <cmath>
#include <numbers>
#include <span>
#include <string>

namespace gonio::select {
namespace {

using std::numbers::pi;

// Angles arrive in degrees, so that a right angle may be off by a rounding.
constexpr double kSlack = 1e-9;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", x);
  return text;
}

std::string degrees(double x) { return number(x * 180 / pi); }

Outcome check(const Range& range, double limit, const std::string& field) {
  const bool sound = range.lower >= 0 && range.lower < range.upper && range.upper <= limit + kSlack;
  if (sound) return Ok{};
  return bad_value(field, "[" + degrees(range.lower) + ", " + degrees(range.upper) + "]",
                   "from 0 to " + degrees(limit) + " degrees, the first below the second");
}

Outcome check(const Bin& bin, const std::string& prefix) {
  if (auto ok = check(bin.theta_i, pi / 2, prefix + "theta_i"); !ok) return ok;
  if (auto ok = check(bin.theta_o, pi / 2, prefix + "theta_o"); !ok) return ok;
  if (auto ok = check(bin.phi, pi, prefix + "phi"); !ok) return ok;
  if (bin.weight > 0 && std::isfinite(bin.weight)) return Ok{};
  return bad_value(prefix + "weight", number(bin.weight), "above 0");
}

Outcome check_edges(std::span<const double> edges, double limit, const std::string& field) {
  if (edges.size() < 2)
    return bad_value(field, std::to_string(edges.size()) + " edges", "at least 2");
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (auto ok = check(Range{edges[i], edges[i + 1]}, limit, field); !ok) return ok;
  }
  return Ok{};
}

Outcome check_counts(std::span<const double> counts, std::size_t expected) {
  const std::string field = "scene.histogram.counts";
  if (counts.size() != expected)
    return bad_value(field, std::to_string(counts.size()) + " numbers",
                     std::to_string(expected) + ", one for each bin");
  double sum = 0;
  for (const double count : counts) {
    if (!(count >= 0) || !std::isfinite(count)) return bad_value(field, number(count), "0 or more");
    sum += count;
  }
  if (!std::isfinite(sum)) return bad_value(field, "a sum beyond 1e308", "a finite sum");
  if (sum > 0) return Ok{};
  return bad_value(field, "all 0", "at least one above 0");
}

}  // namespace

fit::Objective objective_of(Metric metric) {
  switch (metric) {
    case Metric::l1:
      return fit::Objective::l1;
    case Metric::rmse:
      return fit::Objective::l2;
    case Metric::log:
      return fit::Objective::log;
    case Metric::cbrt:
    case Metric::delta_e:
      break;
  }
  return fit::Objective::cbrt;
}

Outcome check(const Scene& scene) {
  if (scene.bins.empty())
    return bad_value("scene", "empty", "ranges theta_i and theta_o, or a histogram of angles");
  if (scene.bins.size() > kMostBins)
    return bad_value("scene.bins", std::to_string(scene.bins.size()) + " bins",
                     "at most " + std::to_string(kMostBins));
  for (std::size_t i = 0; i < scene.bins.size(); ++i) {
    const std::string prefix =
        scene.bins.size() == 1 ? "scene." : "scene.bins[" + std::to_string(i) + "].";
    if (auto ok = check(scene.bins[i], prefix); !ok) return ok;
  }
  double sum = 0;
  for (const Bin& bin : scene.bins) sum += bin.weight;
  if (!std::isfinite(sum))
    return bad_value("scene.bins", "weights of a sum beyond 1e308", "a finite sum");
  if (!(scene.tolerance > 0) || !std::isfinite(scene.tolerance))
    return bad_value("scene.tolerance", number(scene.tolerance), "above 0, of the metric");
  if (!(scene.confidence >= 0.5 && scene.confidence <= 0.9999))
    return bad_value("scene.confidence", number(scene.confidence), "0.5 to 0.9999");
  if (scene.cost == CostKind::ns_variance && scene.lights == Lights::directional)
    return bad_value("scene.cost", "\"ns_variance\" with directional lights",
                     "ns or bytes: nothing is sampled there; or lights \"environment\"");
  return Ok{};
}

Result<std::vector<Bin>> bins_of(const std::vector<double>& theta_i,
                                 const std::vector<double>& theta_o, const std::vector<double>& phi,
                                 const std::vector<double>& counts) {
  const std::string prefix = "scene.histogram.";
  if (auto ok = check_edges(theta_i, pi / 2, prefix + "theta_i"); !ok) return ok.error();
  if (auto ok = check_edges(theta_o, pi / 2, prefix + "theta_o"); !ok) return ok.error();
  if (auto ok = check_edges(phi, pi, prefix + "phi"); !ok) return ok.error();
  const std::size_t rows = theta_o.size() - 1, columns = phi.size() - 1;
  if (auto ok = check_counts(counts, (theta_i.size() - 1) * rows * columns); !ok) return ok.error();
  std::vector<Bin> bins;
  for (std::size_t at = 0; at < counts.size(); ++at) {
    const std::size_t k = at % columns, j = at / columns % rows, i = at / columns / rows;
    if (counts[at] > 0)
      bins.push_back({{theta_i[i], theta_i[i + 1]},
                      {theta_o[j], theta_o[j + 1]},
                      {phi[k], phi[k + 1]},
                      counts[at]});
  }
  return bins;
}

}  // namespace gonio::select
