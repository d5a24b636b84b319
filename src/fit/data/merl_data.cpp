// The cells of a MERL table as pairs of directions, and the measure that each stands for.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/data/data.h"
#include "gonio/measured/table.h"

namespace gonio::fit {
namespace {

using Table = MeasuredTable;
constexpr double kPi = std::numbers::pi;

double theta_h(double cells) {
  const double part = cells / Table::kThetaH;
  return part * part * kPi / 2;
}
double theta_d(double cells) { return cells / Table::kThetaD * kPi / 2; }
double phi_d(double cells) { return cells / Table::kPhiD * kPi; }

double squared_sine(double angle) {
  const double s = std::sin(angle);
  return s * s;
}

// The integral of 2 sin(theta_d) cos(theta_d) over a cell's theta_d as far as both directions are
// above the horizon: tan(theta_d) < 1 / slope, slope = tan(theta_h) |cos(phi_d)|.
double above_horizon(int d, double slope) {
  const double limit = 1 / (1 + slope * slope);
  const double lower = squared_sine(theta_d(d)), upper = squared_sine(theta_d(d + 1));
  return std::max(0.0, std::min(upper, limit) - lower);
}

// Gauss and Legendre's four points on [0, 1].
constexpr std::array<double, 4> kNodes{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                       0.9305681557970263};
constexpr std::array<double, 4> kShares{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                        0.1739274225687269};

// The mean over a cell's theta_h and phi_d of above_horizon; whole where the horizon does not cut
// the cell.
double mean_above_horizon(int h, int d, int p) {
  const double near = std::abs(std::cos(phi_d(p))), far = std::abs(std::cos(phi_d(p + 1)));
  const double steepest = std::tan(theta_h(h + 1)) * std::max(near, far);
  if (1 / (1 + steepest * steepest) >= squared_sine(theta_d(d + 1)) && h + 1 < Table::kThetaH)
    return squared_sine(theta_d(d + 1)) - squared_sine(theta_d(d));
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const double cos_lower = std::cos(theta_h(h)), cos_upper = std::cos(theta_h(h + 1));
    const double tangent = std::tan(std::acos(cos_lower + kNodes[i] * (cos_upper - cos_lower)));
    for (std::size_t j = 0; j < kNodes.size(); ++j) {
      const double slope = tangent * std::abs(std::cos(phi_d(p + kNodes[j])));
      sum += kShares[i] * kShares[j] * above_horizon(d, slope);
      total += kShares[i] * kShares[j];
    }
  }
  return sum / total;
}

void push(std::array<std::vector<float>, 3>& to, double x, double y, double z) {
  to[0].push_back(static_cast<float>(x));
  to[1].push_back(static_cast<float>(y));
  to[2].push_back(static_cast<float>(z));
}

// Sines and cosines of a kind of cell's centres.
template <int kCount>
struct Centres {
  template <class Angle>
  explicit Centres(Angle angle) {
    for (int i = 0; i < kCount; ++i) {
      sine[static_cast<std::size_t>(i)] = std::sin(angle(i + 0.5));
      cosine[static_cast<std::size_t>(i)] = std::cos(angle(i + 0.5));
    }
  }
  std::array<double, kCount> sine, cosine;
};

struct AllCentres {
  Centres<Table::kThetaH> h{theta_h};
  Centres<Table::kThetaD> d{theta_d};
  Centres<Table::kPhiD> p{phi_d};
};

// wi has the angles theta_d, phi_d about h, wo is its mirror image; h is tilted in the plane of u.
// False, and nothing done, where one of the two is below the horizon.
bool push_directions(const AllCentres& at, std::size_t h, std::size_t d, std::size_t p,
                     Data& data) {
  const double x = at.d.sine[d] * at.p.cosine[p], y = at.d.sine[d] * at.p.sine[p];
  const double along = at.h.cosine[h] * at.d.cosine[d], across = at.h.sine[h] * x;
  if (!(static_cast<float>(along - std::abs(across)) > 0)) return false;
  const double forward = at.h.sine[h] * at.d.cosine[d], side = at.h.cosine[h] * x;
  push(data.wi, forward + side, y, along - across);
  push(data.wo, forward - side, -y, along + across);
  return true;
}

}  // namespace

double cell_measure(int h, int d, int p) {
  // d(wi) d(wo) = 4 cos(theta_d) d(h) d(wi about h); phi_h goes round, phi_d half and both ways.
  const double halves = std::cos(theta_h(h)) - std::cos(theta_h(h + 1));
  return 2 * halves * 2 * kPi * 2 * (kPi / Table::kPhiD) * mean_above_horizon(h, d, p);
}

Data from_table(const MeasuredTable& table) {
  Data data;
  data.channels = Table::kChannels;
  const AllCentres centres;
  std::vector<std::size_t> cells;
  cells.reserve(Table::kCells - table.invalid_cells());
  for (auto* components : {&data.wi, &data.wo}) {
    for (auto& component : *components) component.reserve(Table::kCells - table.invalid_cells());
  }
  data.weights.reserve(Table::kCells - table.invalid_cells());
  for (std::size_t cell = 0; cell < Table::kCells; ++cell) {
    const std::size_t p = cell % Table::kPhiD, d = cell / Table::kPhiD % Table::kThetaD,
                      h = cell / Table::kPhiD / Table::kThetaD;
    const bool measured = !std::isnan(table.data()[cell * Table::kChannels]);
    if (!measured || !push_directions(centres, h, d, p, data)) {
      ++(measured ? data.left_out.below_horizon : data.left_out.negative);
      continue;
    }
    data.weights.push_back(static_cast<float>(
        cell_measure(static_cast<int>(h), static_cast<int>(d), static_cast<int>(p))));
    cells.push_back(cell);
  }
  data.values.reserve(cells.size() * static_cast<std::size_t>(Table::kChannels));
  for (std::size_t c = 0; c < static_cast<std::size_t>(Table::kChannels); ++c) {
    for (const std::size_t cell : cells)
      data.values.push_back(table.data()[cell * Table::kChannels + c]);
  }
  return data;
}

}  // namespace gonio::fit
