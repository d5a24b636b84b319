#include "client/picture/render/evaluator.h"

#include <string>
#include <utility>

namespace gonio::render {
namespace {

// Costs and flags add up; what is said of the accuracy is the same in every answer.
void add(client::Report& sum, client::Report next) {
  next.pairs += sum.pairs;
  next.kernel_seconds += sum.kernel_seconds;
  next.flagged += sum.flagged;
  next.retries += sum.retries;
  for (std::size_t bit = 0; bit < client::kFlagBits; ++bit) {
    next.flagged_by[bit] += sum.flagged_by[bit];
  }
  sum = std::move(next);
}

}  // namespace

Result<Evaluator> Evaluator::create(const client::Client& client, client::Material material) {
  auto channels = client.channels(material);
  if (!channels) return channels.error();
  if (*channels != 1 && *channels != 3) {
    return bad_value("--material", "of " + std::to_string(*channels) + " channels",
                     "1 channel (grey), or 3 (red, green, blue)");
  }
  return Evaluator(client, std::move(material), *channels);
}

Outcome Evaluator::evaluate(std::span<const float> viewers, std::span<const float> lights,
                            std::span<Rgb> f, std::span<float> pdf) {
  values_.resize(static_cast<std::size_t>(channels_) * f.size());
  auto report = pdf.empty() ? client_->evaluate(material_, viewers, lights, values_)
                            : client_->evaluate_with_pdf(material_, viewers, lights, values_, pdf);
  if (!report) return report.error();
  add(report_, std::move(report).value());
  take_colours(f);
  return Ok{};
}

Outcome Evaluator::sample(std::span<const float> viewers, std::span<const float> xi,
                          std::span<float> lights, std::span<float> pdf, std::span<Rgb> weights) {
  values_.resize(static_cast<std::size_t>(channels_) * weights.size());
  client::SampleBatch<float> batch;
  batch.wi = viewers;
  batch.xi = xi;
  auto report = client_->sample(material_, batch, {lights, pdf, values_, {}});
  if (!report) return report.error();
  // What is lost below the horizon is in order.
  report->flagged = 0;
  report->flagged_by = {};
  add(report_, std::move(report).value());
  take_colours(weights);
  return Ok{};
}

void Evaluator::take_colours(std::span<Rgb> colours) const {
  const auto channels = static_cast<std::size_t>(channels_);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const float* value = values_.data() + channels * i;
    colours[i] = channels == 3 ? Rgb(value[0], value[1], value[2]) : Rgb::Constant(value[0]);
  }
}

}  // namespace gonio::render
