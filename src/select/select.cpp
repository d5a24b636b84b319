#include "select/select.h"

#include <algorithm>
#include <tuple>

#include "fit/fit.h"
#include "select/candidates.h"
#include "select/walk.h"

namespace gonio::select {
namespace {

constexpr std::size_t kScanPairs = 1000;

struct Task {
  const Scene& scene;
  const Distribution& distribution;
  const Sets& sets;
  const Options& options;
};

double cost_of(const Entry& entry, const Task& task) {
  switch (task.scene.cost) {
    case CostKind::ns:
      return entry.ns;
    case CostKind::bytes:
      return static_cast<double>(entry.bytes);
    case CostKind::ns_variance:
      return entry.ns * entry.second_moment;
  }
  return 0;
}

// All but the material and its errors.
Result<Tried> begin(const Candidate& candidate, const Task& task) {
  Tried tried;
  tried.form = candidate.form;
  tried.anisotropic = candidate.anisotropic;
  tried.entry.name = candidate.name;
  tried.entry.parameters = candidate.parameters;
  const Material typical =
      *Material::create(with_channels(candidate.form, task.sets.fitted.channels));
  tried.entry.bytes = typical.bytes();
  const Result<double> ns =
      task.options.costs.empty()
          ? Result<double>(measured_ns(typical, task.sets.validation, Precision::fast))
          : ns_from(task.options.costs, candidate.parts);
  if (!ns) return ns.error();
  tried.entry.ns = *ns;
  tried.entry.cost = cost_of(tried.entry, task);
  return tried;
}

Outcome fit_to(Tried& tried, const Task& task, const Blocks& validation) {
  fit::Options options;
  options.objective = objective_of(task.scene.metric);
  options.anisotropic = tried.anisotropic;
  options.starts = task.options.starts;
  options.fit_pairs = task.options.sizes.fitted;
  options.scan_pairs = kScanPairs;
  options.seed = task.options.seed;
  auto found = fit::fit(task.sets.fitted, tried.form, options, {{}, task.options.stop});
  if (!found) return found.error();
  tried.entry.material = std::move(found->material);
  tried.entry.at_bounds = std::move(found->certificate.active_bounds);
  tried.material = *Material::create(tried.entry.material);
  tried.errors = errors_of(*tried.material, validation, task.scene.metric);
  return Ok{};
}

bool cheaper(const Tried& a, const Tried& b) {
  return std::tie(a.entry.cost, a.entry.parameters) < std::tie(b.entry.cost, b.entry.parameters);
}

bool same_price(const Tried& a, const Tried& b) { return !cheaper(a, b) && !cheaper(b, a); }

bool errs_less(const Tried& a, const Tried& b) {
  return estimate(a.errors).value < estimate(b.errors).value;
}

// Candidates that wait for their turn, and are fitted when it comes.
class Queue {
 public:
  Queue(const Task& task, const Blocks& validation) : task_(task), validation_(validation) {}

  Outcome add_candidates() {
    const auto all = candidates(task_.scene, task_.sets.fitted.channels, task_.options.lobes);
    for (const Candidate& candidate : all) {
      auto tried = begin(candidate, task_);
      if (!tried) return tried.error();
      waiting_.push_back(std::move(*tried));
    }
    return Ok{};
  }
  void add(Tried tried) { waiting_.push_back(std::move(tried)); }

  // Where a cost depends on what was fitted, that comes first.
  Outcome order() {
    if (task_.scene.cost == CostKind::ns_variance) {
      for (Tried& tried : waiting_) {
        if (auto ok = fit_one(tried); !ok) return ok;
        tried.entry.second_moment =
            relative_second_moment(*tried.material, task_.distribution, task_.options.seed);
        tried.entry.cost = cost_of(tried.entry, task_);
      }
    }
    std::stable_sort(waiting_.begin(), waiting_.end(), cheaper);
    return Ok{};
  }

  // Those of one price go by their errors.
  Outcome walk(Walk& walk) {
    for (auto first = waiting_.begin(); first != waiting_.end();) {
      const auto end = std::find_if(first, waiting_.end(),
                                    [&](const Tried& tried) { return !same_price(*first, tried); });
      for (auto tried = first; tried != end; ++tried) {
        if (auto ok = fit_one(*tried); !ok) return ok;
      }
      std::stable_sort(first, end, errs_less);
      for (; first != end; ++first) walk.take(std::move(*first));
      if (walk.has_choice() && !task_.options.whole_front) break;
    }
    return Ok{};
  }

 private:
  Outcome fit_one(Tried& tried) {
    if (tried.material) return Ok{};
    if (task_.options.progress) task_.options.progress(tried.entry.name, done_, waiting_.size());
    ++done_;
    return fit_to(tried, task_, validation_);
  }
  const Task& task_;
  const Blocks& validation_;
  std::vector<Tried> waiting_;
  std::size_t done_ = 0;
};

// The reference as a candidate of no error; nothing where a table does not say what it costs.
std::optional<Tried> itself(const Material& reference, const Task& task, const Blocks& validation) {
  const CostTable& costs = task.options.costs;
  Tried tried;
  tried.entry.name = kReferencePart;
  tried.entry.bytes = reference.bytes();
  if (costs.empty()) {
    tried.entry.ns = measured_ns(reference, task.sets.validation, Precision::fast);
  } else {
    const auto ns = ns_from(costs, {std::string(kReferencePart)});
    if (!ns) return std::nullopt;
    tried.entry.ns = *ns;
  }
  tried.entry.cost = cost_of(tried.entry, task);
  tried.material = reference;
  tried.errors = errors_of(reference, validation, task.scene.metric);
  return tried;
}

Result<Selection> choose_from(const Material* reference, const Task& task) {
  Walk walk(task.scene, task.sets);
  Queue queue(task, walk.validation());
  if (auto ok = queue.add_candidates(); !ok) return ok.error();
  if (reference != nullptr) {
    auto tried = itself(*reference, task, walk.validation());
    if (tried) queue.add(std::move(*tried));
  }
  if (auto ok = queue.order(); !ok) return ok.error();
  if (auto ok = queue.walk(walk); !ok) return ok.error();
  return std::move(walk).finish();
}

template <class Reference>
Result<Selection> choose_for(const Reference& reference, const Material* itself, const Scene& scene,
                             const Options& options) {
  if (auto ok = check(scene); !ok) return ok.error();
  if (auto ok = check(options); !ok) return ok.error();
  const Distribution distribution(scene);
  const auto sets = sets_of(reference, distribution, options.sizes, options.seed);
  if (!sets) return sets.error();
  if (auto ok = check(scene.metric, sets->fitted.channels); !ok) return ok.error();
  return choose_from(itself, Task{scene, distribution, *sets, options});
}

}  // namespace

bool has_model(const MaterialSpec& material) {
  return material.model || material.diffuse || !material.specular.empty();
}

Outcome check(const Options& options) {
  const auto size = [](std::size_t n) { return std::to_string(n); };
  if (options.lobes < 1 || options.lobes > 2)
    return bad_value("options.lobes", std::to_string(options.lobes), "1 or 2");
  if (options.starts < 1 || options.starts > 100)
    return bad_value("options.starts", size(options.starts), "1 to 100");
  const SetSizes& sizes = options.sizes;
  constexpr std::size_t kFewest = 100, kMost = 1'000'000;
  for (const auto& [name, n] : {std::pair{"fitted", sizes.fitted},
                                {"validation", sizes.validation},
                                {"certification", sizes.certification}}) {
    if (n < kFewest || n > kMost)
      return bad_value(std::string("options.sizes.") + name, size(n),
                       size(kFewest) + " to " + size(kMost));
  }
  return Ok{};
}

// The draws of a material in float64, then the sets, and their blocks beside them.
std::size_t memory_of(int channels, const Options& options) {
  constexpr std::size_t kPair = 160, kValue = 28, kFits = std::size_t{16} << 20;
  return kFits + options.sizes.total() * (kPair + kValue * static_cast<std::size_t>(channels));
}

Result<Selection> choose(const fit::Data& reference, const Scene& scene, const Options& options) {
  return choose_for(reference, nullptr, scene, options);
}

Result<Selection> choose(const Material& reference, const Scene& scene, const Options& options) {
  return choose_for(reference, &reference, scene, options);
}

}  // namespace gonio::select
