#include "select/error/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "fit/report/metrics.h"
#include "gonio/engine/evaluate.h"
#include "select/error/picture.h"

namespace gonio::select {
namespace {

constexpr std::size_t kMostBlocks = 64, kFewestBlocks = 8, kPairsOfBlock = 16;

double of_metric(const fit::Errors& errors, Metric metric) {
  switch (metric) {
    case Metric::l1:
      return errors.l1;
    case Metric::rmse:
      return errors.rmse;
    case Metric::log:
      return errors.log;
    case Metric::cbrt:
      return errors.cbrt;
    case Metric::delta_e:
      break;  // picture_error() computes it
  }
  return 0;
}

bool is_square(Metric metric) { return metric == Metric::rmse || metric == Metric::cbrt; }

struct Sums {
  double measured = 0, weights = 0;
};

Sums sums_of(const fit::Data& data) {
  Sums sums;
  for (int c = 0; c < data.channels; ++c) {
    const auto values = data.channel(c);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const auto w = static_cast<double>(data.weights[i]);
      sums.weights += w;
      sums.measured += w * static_cast<double>(values[i]) * static_cast<double>(data.wi[2][i]);
    }
  }
  return sums;
}

// The numerator from the ratio that compare() formed.
double numerator(double error, const Sums& sums, Metric metric) {
  if (metric == Metric::l1) return error * (sums.measured > 0 ? sums.measured : sums.weights);
  return (is_square(metric) ? error * error : error) * sums.weights;
}

double denominator(const fit::Data& data, Metric metric) {
  if (metric == Metric::delta_e) {
    double seen = 0;
    for (std::size_t i = 0; i < data.size(); ++i)
      seen += static_cast<double>(data.weights[i]) * static_cast<double>(data.wo[2][i]);
    return seen;
  }
  const Sums sums = sums_of(data);
  return metric == Metric::l1 ? sums.measured : sums.weights;
}

// The block's pairs with the material's own values, in float32.
fit::Data as_measured(const Material& material, const fit::Data& block) {
  fit::Data data = block;
  data.channels = material.channels();
  data.values.resize(data.size() * static_cast<std::size_t>(data.channels));
  evaluate(material,
           Batch<float, float>{block.incident(0), block.outgoing(0), block.size(),
                               Values<float>::planar(data.values.data(), block.size()), nullptr},
           best_isa());
  return data;
}

}  // namespace

Outcome check(Metric metric, int channels) {
  if (metric != Metric::delta_e || channels == 1 || channels == 3) return Ok{};
  return bad_value("scene.metric", "delta_e of " + std::to_string(channels) + " channels",
                   "of 1 or 3 channels, grey or linear sRGB");
}

double root_if_square(double ratio, Metric metric) {
  return is_square(metric) ? std::sqrt(std::max(ratio, 0.0)) : std::max(ratio, 0.0);
}

Blocks::Blocks(const fit::Data& data) {
  const std::size_t count = std::clamp(data.size() / kPairsOfBlock, kFewestBlocks, kMostBlocks);
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t begin = b * data.size() / count, end = (b + 1) * data.size() / count;
    std::vector<std::size_t> kept(end - begin);
    std::iota(kept.begin(), kept.end(), begin);
    parts.push_back(fit::pick(data, kept, 1));
  }
}

Ratio error_of(const Material& material, const fit::Data& data, Metric metric) {
  if (metric == Metric::delta_e) return picture_error(material, data);
  const double error = of_metric(fit::compare(material, data, 0).errors.all, metric);
  return {numerator(error, sums_of(data), metric), denominator(data, metric)};
}

std::vector<Ratio> errors_of(const Material& material, const Blocks& blocks, Metric metric) {
  std::vector<Ratio> errors;
  for (const fit::Data& part : blocks.parts) errors.push_back(error_of(material, part, metric));
  return errors;
}

Bounded bounded(const std::vector<Ratio>& errors, Metric metric, double confidence) {
  const Estimate found = estimate(errors);
  const double reach =
      found.standard_error * student_quantile(confidence, static_cast<double>(errors.size()) - 1);
  return {root_if_square(found.value, metric), root_if_square(found.value - reach, metric),
          root_if_square(found.value + reach, metric)};
}

double float32_error(const Material& material, const Blocks& blocks, Metric metric) {
  Ratio sum;
  for (const fit::Data& part : blocks.parts) {
    const fit::Data own = as_measured(material, part);
    // A material of one channel has the same value in all; the colours of a picture need all
    // channels at once.
    const double shared =
        metric == Metric::delta_e ? 1 : static_cast<double>(part.channels) / own.channels;
    sum.numerator += shared * error_of(material, own, metric).numerator;
    sum.denominator += denominator(part, metric);
  }
  return sum.denominator > 0 ? root_if_square(sum.numerator / sum.denominator, metric) : 0;
}

}  // namespace gonio::select
