#include "select/cost.h"

#include <algorithm>
#include <memory>
#include <random>

#include "base/near_names.h"
#include "gonio/base/shown.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/sampler.h"
#include "timing/pairs.h"
#include "timing/race.h"

namespace gonio::select {
namespace {

constexpr std::size_t kTable = std::size_t{1} << 20, kManyPairs = 65'536;
constexpr std::size_t kIncident = 64, kSamples = 256;  // for the second moment

// A suggestion for a part that is missing: the nearest name among those given.
std::string wrongly_written(const CostTable& table, const std::string& part) {
  std::vector<std::string> given;
  for (const auto& [name, ns] : table) given.push_back(name);
  const auto near = nearest_name(part, std::span<const std::string>(given));
  if (!near) return {};
  return "; is it the one that is given as \"" + shown(*near, kQuotedLength) + "\"?";
}

Result<double> ns_from(const CostTable& table, const std::vector<std::string>& parts) {
  double sum = 0;
  for (const std::string& part : parts) {
    const auto found = table.find(part);
    if (found == table.end())
      return bad_value("options.costs", "without \"" + part + "\"",
                       "a number for every part" + wrongly_written(table, part));
    if (!(found->second > 0))
      return bad_value("options.costs." + part, std::to_string(found->second), "above 0");
    sum += found->second;
  }
  return sum;
}

Result<std::vector<double>> measured_ns(const std::vector<Priced>& priced,
                                        const std::function<bool()>& stop) {
  // Less effort than in tests/bench: some sixty materials in half a second.
  constexpr timing::Effort kEffort{.repetitions = 7, .seconds = 0.001};
  int channels = 1;
  for (const Priced& one : priced) channels = std::max(channels, one.material.channels());
  const auto pairs = std::make_shared<timing::Pairs>(timing::kTimedPairs, channels);
  std::shared_ptr<timing::Pairs> many;  // for tables, of which fewer pairs' cells stay in cache
  std::map<std::vector<std::string>, std::size_t> places;
  std::vector<timing::Runner> runners;
  for (const Priced& one : priced) {
    if (!places.emplace(one.parts, runners.size()).second) continue;
    const bool table = one.material.bytes() > kTable;
    if (table && !many) many = std::make_shared<timing::Pairs>(kManyPairs, channels);
    runners.push_back(
        timing::evaluation(table ? many : pairs, one.material, Precision::fast, best_isa()));
  }
  const auto seconds = timing::race(runners, kEffort, stop);
  if (stop && stop()) return Error{ErrorCode::cancelled, "the selection was stopped", {}, {}, {}};
  std::vector<double> ns;
  for (const Priced& one : priced) ns.push_back(1e9 * seconds[places.at(one.parts)].best);
  return ns;
}

}  // namespace

Result<std::vector<double>> ns_of(const std::vector<Priced>& priced, const CostTable& table,
                                  const std::function<bool()>& stop) {
  if (table.empty()) return measured_ns(priced, stop);
  std::vector<double> ns;
  for (const Priced& one : priced) {
    const auto sum = ns_from(table, one.parts);
    if (!sum) return sum.error();
    ns.push_back(*sum);
  }
  return ns;
}

double relative_second_moment(const Material& material, const Distribution& scene,
                              std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<float> wi;
  for (std::size_t i = 0; i < kIncident; ++i) {
    for (const double x : scene.draw(random).wi) wi.push_back(static_cast<float>(x));
  }
  const std::size_t count = kIncident * kSamples;
  const auto channels = static_cast<std::size_t>(material.channels());
  std::vector<float> wo(3 * count), pdf(count), weights(count * channels);
  SampleBatch<float> batch;
  batch.wi = Directions<float>::interleaved(wi.data());
  batch.count = count;
  batch.per_wi = kSamples;
  batch.numbers = {Sequence::random, seed};
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  batch.weights = Values<float>::planar(weights.data(), count);
  sample(Sampler::create(material), batch, best_isa());
  double squares = 0, means = 0;
  for (std::size_t i = 0; i < kIncident; ++i) {
    double sum = 0, square = 0;
    for (std::size_t s = i * kSamples; s < (i + 1) * kSamples; ++s) {
      double weight = 0;
      for (std::size_t c = 0; c < channels; ++c)
        weight += static_cast<double>(weights[c * count + s]);
      sum += weight / kSamples;
      square += weight * weight / kSamples;
    }
    squares += square;
    means += sum * sum;
  }
  return means > 0 ? squares / means : 1;
}

}  // namespace gonio::select
