// Candidates by cost, fitted when their turn comes.
#pragma once

#include <vector>

#include "select/error/distribution.h"
#include "select/front_builder.h"
#include "select/select.h"

namespace gonio::select {

struct Task {
  const Scene& scene;
  const Distribution& distribution;
  const Sets& sets;
  const Options& options;
};

class Queue {
 public:
  Queue(const Task& task, const Blocks& validation) : task_(task), validation_(validation) {}

  // All candidates and, if it is a material, the reference, by cost. Where the cost depends on the
  // fitted numbers, all are fitted here. Errors: costs; cancelled.
  Outcome fill(const Material* reference);

  // In ascending order of cost; those of equal cost in ascending order of error.
  Outcome fit_by_cost(FrontBuilder& front);

 private:
  void add_reference(const Material& reference);
  Outcome set_prices();
  Outcome fit_one(FittedCandidate& candidate);
  [[nodiscard]] double cost_of(const Entry& entry) const;

  const Task& task_;
  const Blocks& validation_;
  std::vector<FittedCandidate> waiting_;
  std::size_t done_ = 0;
};

}  // namespace gonio::select
