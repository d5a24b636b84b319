#include "select/queue.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fit/fit.h"
#include "select/candidates.h"

namespace gonio::select {
namespace {

constexpr std::size_t kScanPairs = 1000;

bool cheaper(const FittedCandidate& a, const FittedCandidate& b) {
  return std::tie(a.entry.cost, a.entry.parameters) < std::tie(b.entry.cost, b.entry.parameters);
}

bool same_price(const FittedCandidate& a, const FittedCandidate& b) {
  return !cheaper(a, b) && !cheaper(b, a);
}

bool errs_less(const FittedCandidate& a, const FittedCandidate& b) {
  return estimate(a.errors).value < estimate(b.errors).value;
}

}  // namespace

double Queue::cost_of(const Entry& entry) const {
  switch (task_.scene.cost) {
    case CostKind::ns:
      return entry.ns;
    case CostKind::bytes:
      return static_cast<double>(entry.bytes);
    case CostKind::ns_variance:
      return entry.ns * entry.second_moment;
  }
  return 0;
}

// The reference as a candidate that needs no fit.
void Queue::add_reference(const Material& reference) {
  FittedCandidate candidate;
  candidate.entry.name = kReferencePart;
  candidate.entry.bytes = reference.bytes();
  candidate.parts = {std::string(kReferencePart)};
  candidate.material = reference;
  candidate.errors = errors_of(reference, validation_, task_.scene.metric);
  waiting_.push_back(std::move(candidate));
}

// Candidates of the same parts have the same cost, whatever their numbers.
Outcome Queue::set_prices() {
  std::vector<Priced> priced;
  for (const FittedCandidate& candidate : waiting_) {
    priced.push_back({candidate.parts, candidate.material
                                           ? *candidate.material
                                           : *Material::create(with_channels(
                                                 candidate.form, task_.sets.fitted.channels))});
  }
  const auto prices = ns_of(priced, task_.options.costs, task_.options.stop);
  if (!prices) return prices.error();
  for (std::size_t i = 0; i < waiting_.size(); ++i) waiting_[i].entry.ns = (*prices)[i];
  return Ok{};
}

Outcome Queue::fit_one(FittedCandidate& candidate) {
  if (candidate.material) return Ok{};
  if (task_.options.progress) task_.options.progress(candidate.entry.name, done_, waiting_.size());
  ++done_;
  fit::Options options;
  options.objective = objective_of(task_.scene.metric);
  options.anisotropic = candidate.anisotropic;
  options.hints = false;
  options.starts = task_.options.starts;
  options.fit_pairs = task_.options.sizes.fitted;
  options.scan_pairs = kScanPairs;
  options.seed = task_.options.seed;
  auto found = fit::fit(task_.sets.fitted, candidate.form, options, {{}, task_.options.stop});
  if (!found) return found.error();
  candidate.entry.material = std::move(found->material);
  candidate.entry.at_bounds = std::move(found->certificate.active_bounds);
  candidate.material = *Material::create(*candidate.entry.material);
  candidate.errors = errors_of(*candidate.material, validation_, task_.scene.metric);
  return Ok{};
}

Outcome Queue::fill(const Material* reference) {
  const int channels = task_.sets.fitted.channels;
  for (const Candidate& listed : candidates(task_.scene, channels, task_.options.lobes)) {
    FittedCandidate candidate;
    candidate.form = listed.form;
    candidate.parts = listed.parts;
    candidate.anisotropic = listed.anisotropic;
    candidate.entry.name = listed.name;
    candidate.entry.parameters = listed.parameters;
    candidate.entry.bytes = Material::create(with_channels(listed.form, channels))->bytes();
    waiting_.push_back(std::move(candidate));
  }
  // Without a cost for it in the table the reference is left out.
  const CostTable& costs = task_.options.costs;
  if (reference != nullptr && (costs.empty() || costs.contains(kReferencePart)))
    add_reference(*reference);
  if (auto ok = set_prices(); !ok) return ok;
  const bool by_samples = task_.scene.cost == CostKind::ns_variance;
  for (FittedCandidate& candidate : waiting_) {
    if (by_samples) {
      if (auto ok = fit_one(candidate); !ok) return ok;
      candidate.entry.second_moment =
          relative_second_moment(*candidate.material, task_.distribution, task_.options.seed);
    }
    candidate.entry.cost = cost_of(candidate.entry);
  }
  std::stable_sort(waiting_.begin(), waiting_.end(), cheaper);
  return Ok{};
}

Outcome Queue::fit_by_cost(FrontBuilder& front) {
  auto first = waiting_.begin();
  while (first != waiting_.end()) {
    if (front.has_choice() && !task_.options.whole_front) break;
    const auto end = std::find_if(first, waiting_.end(), [&](const FittedCandidate& candidate) {
      return !same_price(*first, candidate);
    });
    for (auto candidate = first; candidate != end; ++candidate) {
      if (auto ok = fit_one(*candidate); !ok) return ok;
    }
    std::stable_sort(first, end, errs_less);
    for (; first != end; ++first) front.add(std::move(*first));
  }
  // Of what costs more than the choice only the reference is examined, because it needs no fit.
  for (; first != waiting_.end(); ++first) {
    if (first->material) front.add(std::move(*first));
  }
  return Ok{};
}

}  // namespace gonio::select
