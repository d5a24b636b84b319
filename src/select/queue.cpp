#include "select/queue.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fit/fit.h"
#include "select/candidates.h"

namespace gonio::select {
namespace {

constexpr std::size_t kScanPairs = 1000;

bool cheaper(const Tried& a, const Tried& b) {
  return std::tie(a.entry.cost, a.entry.parameters) < std::tie(b.entry.cost, b.entry.parameters);
}

bool same_price(const Tried& a, const Tried& b) { return !cheaper(a, b) && !cheaper(b, a); }

bool errs_less(const Tried& a, const Tried& b) {
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
  Tried tried;
  tried.entry.name = kReferencePart;
  tried.entry.bytes = reference.bytes();
  tried.parts = {std::string(kReferencePart)};
  tried.material = reference;
  tried.errors = errors_of(reference, validation_, task_.scene.metric);
  waiting_.push_back(std::move(tried));
}

// Candidates of the same parts have the same cost, whatever their numbers.
Outcome Queue::set_prices() {
  std::vector<Priced> priced;
  for (const Tried& tried : waiting_) {
    priced.push_back({tried.parts, tried.material ? *tried.material
                                                  : *Material::create(with_channels(
                                                        tried.form, task_.sets.fitted.channels))});
  }
  const auto prices = ns_of(priced, task_.options.costs, task_.options.stop);
  if (!prices) return prices.error();
  for (std::size_t i = 0; i < waiting_.size(); ++i) waiting_[i].entry.ns = (*prices)[i];
  return Ok{};
}

Outcome Queue::fit_one(Tried& tried) {
  if (tried.material) return Ok{};
  if (task_.options.progress) task_.options.progress(tried.entry.name, done_, waiting_.size());
  ++done_;
  fit::Options options;
  options.objective = objective_of(task_.scene.metric);
  options.anisotropic = tried.anisotropic;
  options.hints = false;
  options.starts = task_.options.starts;
  options.fit_pairs = task_.options.sizes.fitted;
  options.scan_pairs = kScanPairs;
  options.seed = task_.options.seed;
  auto found = fit::fit(task_.sets.fitted, tried.form, options, {{}, task_.options.stop});
  if (!found) return found.error();
  tried.entry.material = std::move(found->material);
  tried.entry.at_bounds = std::move(found->certificate.active_bounds);
  tried.material = *Material::create(*tried.entry.material);
  tried.errors = errors_of(*tried.material, validation_, task_.scene.metric);
  return Ok{};
}

Outcome Queue::fill(const Material* reference) {
  const int channels = task_.sets.fitted.channels;
  for (const Candidate& candidate : candidates(task_.scene, channels, task_.options.lobes)) {
    Tried tried;
    tried.form = candidate.form;
    tried.parts = candidate.parts;
    tried.anisotropic = candidate.anisotropic;
    tried.entry.name = candidate.name;
    tried.entry.parameters = candidate.parameters;
    tried.entry.bytes = Material::create(with_channels(candidate.form, channels))->bytes();
    waiting_.push_back(std::move(tried));
  }
  // Without a cost for it in the table the reference is left out.
  const CostTable& costs = task_.options.costs;
  if (reference != nullptr && (costs.empty() || costs.contains(kReferencePart)))
    add_reference(*reference);
  if (auto ok = set_prices(); !ok) return ok;
  const bool by_samples = task_.scene.cost == CostKind::ns_variance;
  for (Tried& tried : waiting_) {
    if (by_samples) {
      if (auto ok = fit_one(tried); !ok) return ok;
      tried.entry.second_moment =
          relative_second_moment(*tried.material, task_.distribution, task_.options.seed);
    }
    tried.entry.cost = cost_of(tried.entry);
  }
  std::stable_sort(waiting_.begin(), waiting_.end(), cheaper);
  return Ok{};
}

Outcome Queue::walk(Walk& walk) {
  auto first = waiting_.begin();
  while (first != waiting_.end()) {
    if (walk.has_choice() && !task_.options.whole_front) break;
    const auto end = std::find_if(first, waiting_.end(),
                                  [&](const Tried& tried) { return !same_price(*first, tried); });
    for (auto tried = first; tried != end; ++tried) {
      if (auto ok = fit_one(*tried); !ok) return ok;
    }
    std::stable_sort(first, end, errs_less);
    for (; first != end; ++first) walk.take(std::move(*first));
  }
  // Of what costs more than the choice only the reference is examined, because it needs no fit.
  for (; first != waiting_.end(); ++first) {
    if (first->material) walk.take(std::move(*first));
  }
  return Ok{};
}

}  // namespace gonio::select
