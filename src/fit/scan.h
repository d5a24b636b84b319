// A coarse grid over the shape parameters, with everything linear solved exactly at each node: it
// needs no start, and finds the basins that a descent from somewhere would miss.
#pragma once

#include <span>
#include <vector>

#include "fit/fit.h"
#include "fit/node.h"
#include "fit/problem.h"

namespace gonio::fit {

// Does it say how wide a lobe is? That changes f most; Fresnel and shares are gentle.
bool is_width(const ShapeParameter& shape);

// The values of each shape (search scale) along the grid: roughness finest, since lobes that do not
// overlap know nothing of each other.
std::vector<std::vector<double>> scan_axes(const Form& form);

// The nodes' objectives, the first axis the slowest, and those to descend from.
struct Scan {
  std::size_t nodes = 0;
  std::vector<Node> best;  // the most distinct good ones, the best first
  bool stopped = false;
};
Scan scan(const Problem& problem, std::size_t keep, const Watch& watch);

}  // namespace gonio::fit
