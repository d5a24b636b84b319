// The types of directions and values on the wire: bytes a pair against error.
#include <array>

#include "assess/places.h"
#include "chart/cases.h"
#include "chart/chart.h"
#include "chart/common.h"

namespace gonio::chart {
namespace {

using Numbers = std::vector<double>;

struct Types {
  const char* name;
  bool directions64, values64;
  double bytes;  // of a pair with three channels
};
constexpr std::array kTypes{Types{"float32", false, false, 36},
                            Types{"float32 to float64", false, true, 48},
                            Types{"float64", true, true, 72}};

template <class In, class Out>
std::vector<double> values_of(const Material& material, const std::vector<assess::Pair>& pairs) {
  std::vector<In> wi, wo;
  for (const assess::Pair& pair : pairs) {
    for (const double x : pair.wi) wi.push_back(static_cast<In>(x));
    for (const double x : pair.wo) wo.push_back(static_cast<In>(x));
  }
  const int channels = material.channels();
  std::vector<Out> values(pairs.size() * static_cast<std::size_t>(channels));
  evaluate(
      material,
      Batch<In, Out>{Directions<In>::interleaved(wi.data()), Directions<In>::interleaved(wo.data()),
                     pairs.size(), Values<Out>::interleaved(values.data(), channels), nullptr},
      best_isa());
  return {values.begin(), values.end()};
}

std::vector<double> values_of(const Material& material, const std::vector<assess::Pair>& pairs,
                              const Types& types) {
  if (types.directions64) return values_of<double, double>(material, pairs);
  if (types.values64) return values_of<float, double>(material, pairs);
  return values_of<float, float>(material, pairs);
}

// Errors to f at the directions before rounding.
ErrorStatistics errors_of(const std::vector<double>& values, const assess::Subject& subject,
                          const std::vector<assess::Pair>& pairs) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  assess::ErrorList errors;
  std::vector<long double> truth(channels);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    subject.truth.evaluate(pairs[i].wi, pairs[i].wo, truth);
    for (std::size_t c = 0; c < channels; ++c) {
      const double value = values[i * channels + c];
      if (!(truth[c] > 1e-6L)) continue;  // below, a picture would not show it
      errors.relative.push_back(static_cast<double>(std::abs(value - truth[c]) / truth[c]));
    }
  }
  return statistics_of(std::move(errors));
}

// Pairs anywhere, and about the lobe.
std::vector<assess::Pair> pairs_of(const assess::Subject& subject, const Options& options) {
  std::vector<assess::Pair> pairs;
  for (std::size_t place = 0; place < assess::places().size(); ++place) {
    const auto name = assess::places()[place].name;
    if (name != "hemisphere" && name != "lobe") continue;
    const auto at = assess::pairs_at(place, subject, 10 * options.pairs, options.seed);
    pairs.insert(pairs.end(), at.begin(), at.end());
  }
  return pairs;
}

}  // namespace

Result<Table> chart_directions(const Options& options) {
  Table table{
      "directions",
      "The types on the wire: bytes a pair of three channels against error, for lobes of ggx",
      {{"material", "", "ggx of this roughness"},
       {"alpha", "1", "its roughness"},
       {"types", "", "of directions and values"},
       {"bytes", "B", "on the wire, of one pair"}},
      {}};
  add_error_columns(table);
  for (const double alpha : {0.3, 0.03, 0.003}) {
    char name[32];
    std::snprintf(name, sizeof(name), "alpha = %g", alpha);
    const Material material = *Material::create(alone({"ggx",
                                                       {{"alpha_x", Numbers{alpha}},
                                                        {"alpha_y", Numbers{alpha}},
                                                        {"f0", Numbers{0.9, 0.8, 0.7}}}}));
    const assess::Subject subject = assess::subject_of(Sampler::create(material), best_isa());
    const auto pairs = pairs_of(subject, options);
    for (const Types& types : kTypes) {
      if (is_over(options)) return was_cancelled();
      std::vector<Cell> row{std::string(name), alpha, std::string(types.name), types.bytes};
      add_error_cells(row, errors_of(values_of(material, pairs, types), subject, pairs));
      table.rows.push_back(std::move(row));
    }
  }
  add_front(table, "bytes", "error_999", "material");
  show(options, 1);
  return table;
}

}  // namespace gonio::chart
