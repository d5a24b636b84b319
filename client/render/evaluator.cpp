#include "client/render/evaluator.h"

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

Outcome Evaluator::evaluate(std::span<const float> wi, std::span<const float> wo,
                            std::span<image::Rgb> values) {
  const auto channels = static_cast<std::size_t>(channels_);
  values_.resize(channels * values.size());
  auto report = client_->evaluate(material_, wi, wo, values_);
  if (!report) return report.error();
  add(report_, std::move(report).value());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float* f = values_.data() + channels * i;
    values[i] = channels == 3 ? image::Rgb(f[0], f[1], f[2]) : image::Rgb::Constant(f[0]);
  }
  return Ok{};
}

}  // namespace gonio::render
