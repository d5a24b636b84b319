// Bins of a subdivision's cells, and integrals of other columns over them.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "assess/hemisphere.h"

namespace gonio::assess {
namespace {

std::size_t interval_of(const std::vector<double>& edges, double x) {
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, x);
  return static_cast<std::size_t>(above - edges.begin()) - 1;
}

}  // namespace

std::vector<double> Subdivision::integrals(std::size_t columns,
                                           const Integrands& integrands) const {
  std::vector<Cell> leaves;
  std::ranges::copy_if(cells_, std::back_inserter(leaves),
                       [](const Cell& cell) { return cell.child == 0; });
  const std::vector<double> of_leaves = integrate(leaves, columns, integrands);
  std::vector<double> sums(columns);
  for (std::size_t i = 0; i < of_leaves.size(); ++i) {
    if (const std::size_t column = i % (columns + 1); column < columns)
      sums[column] += of_leaves[i];
  }
  return sums;
}

std::vector<Bin> Subdivision::bins(double least) {
  std::vector<Bin> bins(1);
  const std::size_t first = (u_edges_.size() - 1) * (t_edges_.size() - 1);
  for (std::size_t i = 0; i < first; ++i) gather(i, least, bins);
  // The rest at the end is too little for a bin of its own and is added to the last bin.
  if (bins.size() > 1 && bins.back().mass < least) {
    Bin& last = bins[bins.size() - 2];
    last.mass += bins.back().mass, last.solid_angle += bins.back().solid_angle;
    for (Cell& cell : cells_) cell.bin = std::min(cell.bin, bins.size() - 2);
    bins.pop_back();
  }
  return bins;
}

void Subdivision::gather(std::size_t cell, double least, std::vector<Bin>& bins) {
  if (const std::size_t child = cells_[cell].child; child != 0) {
    gather(child, least, bins);
    gather(child + 1, least, bins);
    return;
  }
  if (bins.back().mass >= least) bins.emplace_back();
  Cell& leaf = cells_[cell];
  Bin& bin = bins.back();
  bin.mass += integrals_[cell * columns_];
  bin.solid_angle += integrals_[cell * columns_ + columns_ - 1];
  bin.centre = direction((leaf.u0 + leaf.u1) / 2, (leaf.t0 + leaf.t1) / 2);
  leaf.bin = bins.size() - 1;
}

std::size_t Subdivision::bin_of(const Direction& wo) const {
  const double x = wi_[0] + wo[0], y = wi_[1] + wo[1], z = wi_[2] + wo[2];
  const double turns = std::atan2(y, x) / (2 * std::numbers::pi), u = turns < 0 ? turns + 1 : turns;
  const double t = std::min(1.0, std::atan2(std::hypot(x, y), z) / reach(u));
  std::size_t at = interval_of(u_edges_, u) * (t_edges_.size() - 1) + interval_of(t_edges_, t);
  while (cells_[at].child != 0) {
    const Cell& cell = cells_[at];
    const bool second = cell.across_u ? u >= (cell.u0 + cell.u1) / 2 : t >= (cell.t0 + cell.t1) / 2;
    at = cell.child + (second ? 1 : 0);
  }
  return cells_[at].bin;
}

}  // namespace gonio::assess
