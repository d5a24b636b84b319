#include "assess/hemisphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::assess {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 1e-6;  // of a cell, relative to the whole integral
// For few columns; for many columns there are fewer cells.
constexpr std::size_t kMostCells = 60'000, kMostNumbers = 600'000;

constexpr std::size_t kNodes = 5;
constexpr std::array<double, kNodes> kAt{0.0469100770306680, 0.2307653449471585, 0.5,
                                         0.7692346550528415, 0.9530899229693320};
constexpr std::array<double, kNodes> kWeight{0.1184634425280945, 0.2393143352496832,
                                             0.2844444444444444, 0.2393143352496832,
                                             0.1184634425280945};

// Sorted, without numbers that almost coincide.
void tidy(std::vector<double>& edges) {
  std::ranges::sort(edges);
  const auto near = [](double a, double b) { return b - a < 1e-9; };
  edges.erase(std::unique(edges.begin(), edges.end(), near), edges.end());
}

}  // namespace

Subdivision::Subdivision(const Direction& wi, std::size_t columns, const Integrands& integrands,
                         double tangents, double largest)
    : wi_(wi), columns_(columns + 1), largest_(largest) {
  lay_first_cells(tangents);
  integrals_ = integrate(cells_, columns, integrands);
  scales_.assign(columns_, 0);
  for (std::size_t i = 0; i < integrals_.size(); ++i) scales_[i % columns_] += integrals_[i];
  changes_.assign(columns_, 0);
  refine(integrands);
  totals_.assign(columns_, 0);
  for (std::size_t i = 0; i < integrals_.size(); ++i) {
    if (cells_[i / columns_].child == 0) totals_[i % columns_] += integrals_[i];
  }
}

void Subdivision::lay_first_cells(double tangents) {
  const double of_wi = std::atan2(wi_[1], wi_[0]) / (2 * kPi);
  u_edges_ = {0, 1};
  for (const double start : {tangents / (2 * kPi), of_wi}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      for (int k = -7; k <= 7; ++k) {
        const double size = k == 0 ? 0 : std::ldexp(1. / 16, -2 * (std::abs(k) - 1));
        const double u = start + 0.25 * quarter + (k < 0 ? -size : size);
        u_edges_.push_back(u - std::floor(u));
      }
    }
  }
  tidy(u_edges_);
  t_edges_ = {0};
  for (int k = 13; k >= 0; --k) t_edges_.push_back(std::ldexp(1, -2 * k));
  for (int k = 1; k <= 14; k += 2) t_edges_.push_back(1 - std::ldexp(1, -k));
  tidy(t_edges_);
  for (std::size_t u = 0; u + 1 < u_edges_.size(); ++u) {
    for (std::size_t t = 0; t + 1 < t_edges_.size(); ++t)
      cells_.push_back({u_edges_[u], u_edges_[u + 1], t_edges_[t], t_edges_[t + 1]});
  }
}

double Subdivision::reach(double u) const {
  const double toward = wi_[0] * std::cos(2 * kPi * u) + wi_[1] * std::sin(2 * kPi * u);
  return kPi / 4 + std::atan2(toward, wi_[2]) / 2;
}

Direction Subdivision::direction(double u, double t) const {
  const double theta = t * reach(u), sine = std::sin(theta);
  const Direction h{sine * std::cos(2 * kPi * u), sine * std::sin(2 * kPi * u), std::cos(theta)};
  const double hk = h[0] * wi_[0] + h[1] * wi_[1] + h[2] * wi_[2];
  return {2 * hk * h[0] - wi_[0], 2 * hk * h[1] - wi_[1], 2 * hk * h[2] - wi_[2]};
}

// d(omega) = 4 (h.wi) d(omega_h), d(omega_h) = sin(theta) d(theta) d(phi).
void Subdivision::append_nodes(const Cell& cell, std::vector<double>& wo,
                               std::vector<double>& weights) const {
  for (std::size_t i = 0; i < kNodes; ++i) {
    const double u = std::lerp(cell.u0, cell.u1, kAt[i]), most = reach(u);
    const double cosine = std::cos(2 * kPi * u), sine = std::sin(2 * kPi * u);
    const double toward = wi_[0] * cosine + wi_[1] * sine;
    for (std::size_t j = 0; j < kNodes; ++j) {
      const double theta = std::lerp(cell.t0, cell.t1, kAt[j]) * most;
      const double z = std::cos(theta), across = std::sin(theta);
      const double hk = toward * across + wi_[2] * z;
      wo.insert(wo.end(), {2 * hk * across * cosine - wi_[0], 2 * hk * across * sine - wi_[1],
                           2 * hk * z - wi_[2]});
      const double area = kWeight[i] * (cell.u1 - cell.u0) * kWeight[j] * (cell.t1 - cell.t0);
      weights.push_back(area * 2 * kPi * most * across * 4 * hk);
    }
  }
}

// A few cells at a time: the values of many channels would otherwise take a gigabyte.
std::vector<double> Subdivision::integrate(const std::vector<Cell>& cells, std::size_t given,
                                           const Integrands& integrands) const {
  constexpr std::size_t kRun = 64, kSquare = kNodes * kNodes;
  std::vector<double> wo, weights, sums(cells.size() * (given + 1));
  for (std::size_t begin = 0; begin < cells.size(); begin += kRun) {
    wo.clear();
    weights.clear();
    for (std::size_t i = begin; i < std::min(begin + kRun, cells.size()); ++i)
      append_nodes(cells[i], wo, weights);
    const std::vector<double> values = integrands(wo);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      double* to = &sums[(begin + i / kSquare) * (given + 1)];
      for (std::size_t c = 0; c < given; ++c) to[c] += weights[i] * values[i * given + c];
      to[given] += weights[i];
    }
  }
  return sums;
}

// Both halves across u, then both across t.
std::array<Subdivision::Cell, 4> Subdivision::halves_of(const Cell& cell) const {
  const double u = (cell.u0 + cell.u1) / 2, t = (cell.t0 + cell.t1) / 2;
  return {{{cell.u0, u, cell.t0, cell.t1},
           {u, cell.u1, cell.t0, cell.t1},
           {cell.u0, cell.u1, cell.t0, t},
           {cell.u0, cell.u1, t, cell.t1}}};
}

void Subdivision::refine(const Integrands& integrands) {
  std::vector<std::size_t> wave;
  const auto matters = [&](std::size_t cell) {
    for (std::size_t c = 0; c + 1 < columns_; ++c) {
      if (integrals_[cell * columns_ + c] > kTolerance / 100 * scales_[c]) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (matters(i)) wave.push_back(i);
  }
  while (!wave.empty()) {
    std::vector<Cell> tried;
    for (const std::size_t i : wave) {
      const auto halves = halves_of(cells_[i]);
      tried.insert(tried.end(), halves.begin(), halves.end());
    }
    const std::vector<double> sums = integrate(tried, columns_ - 1, integrands);
    std::vector<std::size_t> next;
    for (std::size_t k = 0; k < wave.size(); ++k) {
      const auto at = sums.begin() + static_cast<std::ptrdiff_t>(4 * k * columns_);
      settle(wave[k], {at, at + static_cast<std::ptrdiff_t>(4 * columns_)}, next);
    }
    std::erase_if(next, [&](std::size_t i) { return !matters(i); });
    wave = std::move(next);
  }
}

// Replaces a cell's values by the more accurate ones of its halves, and splits it if the two differ
// too much.
void Subdivision::settle(std::size_t cell, const std::vector<double>& halves,
                         std::vector<std::size_t>& next) {
  double by_u = 0, by_t = 0;
  for (std::size_t c = 0; c + 1 < columns_; ++c) {
    if (!(scales_[c] > 0)) continue;
    const double whole = integrals_[cell * columns_ + c];
    const auto changed = [&](std::size_t first) {
      return std::abs(halves[first * columns_ + c] + halves[(first + 1) * columns_ + c] - whole) /
             scales_[c];
    };
    by_u = std::max(by_u, changed(0));
    by_t = std::max(by_t, changed(2));
  }
  const bool across_u = by_u > by_t;
  const std::size_t first = across_u ? 0 : 2;
  const bool coarse = integrals_[cell * columns_] > largest_;
  const std::size_t most = std::min(kMostCells, kMostNumbers / columns_);
  if ((std::max(by_u, by_t) > kTolerance || coarse) && cells_.size() < most) {
    const auto parts = halves_of(cells_[cell]);
    cells_[cell].child = cells_.size();
    cells_[cell].across_u = across_u;
    for (std::size_t half = 0; half < 2; ++half) {
      next.push_back(cells_.size());
      cells_.push_back(parts[first + half]);
      for (std::size_t c = 0; c < columns_; ++c)
        integrals_.push_back(halves[(first + half) * columns_ + c]);
    }
    return;
  }
  for (std::size_t c = 0; c < columns_; ++c) {
    const double sum = halves[first * columns_ + c] + halves[(first + 1) * columns_ + c];
    changes_[c] += std::abs(sum - integrals_[cell * columns_ + c]);
    integrals_[cell * columns_ + c] = sum;
  }
}

}  // namespace gonio::assess
