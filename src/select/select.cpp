#include "select/select.h"

#include "select/front_builder.h"
#include "select/queue.h"

namespace gonio::select {
namespace {

Result<Selection> choose_from(const Material* reference, const Task& task) {
  FrontBuilder front(task.scene, task.sets);
  Queue queue(task, front.validation());
  if (auto ok = queue.fill(reference); !ok) return ok.error();
  if (auto ok = queue.fit_by_cost(front); !ok) return ok.error();
  return std::move(front).finish();
}

template <class Reference>
Result<Selection> choose_for(const Reference& reference, const Material* itself, const Scene& scene,
                             const Options& options) {
  if (auto ok = check(scene); !ok) return ok.error();
  if (auto ok = check(options); !ok) return ok.error();
  const Distribution distribution(scene);
  const auto sets = sets_of(reference, distribution, options.sizes, options.seed, options.stop);
  if (!sets) return sets.error();
  if (auto ok = check(scene.metric, sets->fitted.channels); !ok) return ok.error();
  return choose_from(itself, Task{scene, distribution, *sets, options});
}

}  // namespace

Result<Selection> choose(const fit::Data& reference, const Scene& scene, const Options& options) {
  return choose_for(reference, nullptr, scene, options);
}

Result<Selection> choose(const Material& reference, const Scene& scene, const Options& options) {
  return choose_for(reference, &reference, scene, options);
}

}  // namespace gonio::select
