// A coarse grid over the shape parameters, with everything linear solved exactly at each node: it
// needs no start, and finds the basins that a descent from somewhere would miss.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/fit.h"
#include "fit/linear/solved_colours.h"
#include "fit/search/problem.h"

namespace gonio::fit {

// A shape that a scan leaves where it is, in search scale.
struct Held {
  std::size_t shape = 0;
  double at = 0;
};

// The values of each shape (search scale) along the grid: roughness finest, since lobes that do not
// overlap know nothing of each other. A shape that is held has one value, which leaves more to the
// others.
std::vector<std::vector<double>> scan_axes(const Form& form, std::optional<Held> held = {});

// The nodes' objectives, the first axis the slowest, and those to descend from.
struct Scan {
  std::size_t nodes = 0;
  std::vector<SolvedColours> best;  // the most distinct good ones, the best first
  bool stopped = false;
};
Scan scan(const Problem& problem, std::size_t keep, const Watch& watch,
          std::optional<Held> held = {});

}  // namespace gonio::fit
