#include "measured/merl/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/direction.h"

namespace gonio {
namespace {

constexpr double kPi = std::numbers::pi;

// What the azimuth is counted from: the tangent below wi.
struct Tangent {
  double x = 1, y = 0;
  explicit Tangent(const Direction& wi) {
    const double length = std::hypot(wi[0], wi[1]);
    if (length > 0) x = wi[0] / length, y = wi[1] / length;
  }
};

// wi reflected by the half-vector at 1 - cos(theta_h) = `down` and an azimuth from wi's.
Direction reflected(const Direction& wi, double down, double azimuth) {
  const Tangent u(wi);
  const double sine = std::sqrt(down * (2 - down));
  const double x = sine * std::cos(azimuth), y = sine * std::sin(azimuth);
  const Direction h{x * u.x - y * u.y, x * u.y + y * u.x, 1 - down};
  const double twice = 2 * dot(wi, h);
  return {twice * h[0] - wi[0], twice * h[1] - wi[1], twice * h[2] - wi[2]};
}

// The cell of a cumulated table that holds `u`, and u's place in it.
struct Found {
  std::size_t cell;
  double place;
};
Found find(std::span<const float> cumulated, double u) {
  const auto last = cumulated.end() - 1;
  const auto after = std::upper_bound(cumulated.begin() + 1, last, static_cast<float>(u));
  const auto cell = static_cast<std::size_t>(after - cumulated.begin()) - 1;
  const double low = cumulated[cell], width = cumulated[cell + 1] - low;
  return {cell, width > 0 ? std::clamp((u - low) / width, 0.0, 1.0) : 0.5};
}

// Makes the masses in cumulated[1 ...] what their name says; evenly where there are none. Returns
// their sum.
double cumulate(std::span<float> cumulated, std::span<const double> masses) {
  double sum = 0;
  for (const double mass : masses) sum += mass;
  double below = 0;
  cumulated[0] = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    below += sum > 0 ? masses[i] / sum : 1.0 / static_cast<double>(masses.size());
    cumulated[i + 1] = static_cast<float>(std::min(below, 1.0));
  }
  cumulated.back() = 1;
  return sum;
}

}  // namespace

TableSampling::TableSampling(const Luminance& luminance) : angles_(kAngles) {
  for (std::size_t i = 0; i < edge_.size(); ++i) {
    // As the table's own colatitudes, spaced by squares.
    const double part = static_cast<double>(i) / kColatitudes;
    const double sine = std::sin(kPi / 4 * part * part);
    edge_[i] = 2 * sine * sine;
  }
  for (std::size_t i = 0; i < angles_.size(); ++i) tabulate(i, luminance);
}

void TableSampling::tabulate(std::size_t angle, const Luminance& luminance) {
  // The last angle stands for grazing incidence, where nothing is measured.
  const double theta = std::min(static_cast<double>(angle) / (kAngles - 1) * kPi / 2, 1.55);
  const Direction wi{std::sin(theta), 0, std::cos(theta)};
  constexpr int kAcross = 2;  // points in a cell, each way
  constexpr std::size_t kPoints = std::size_t{kAcross} * kAcross * kAzimuths;
  std::vector<Direction> from(kPoints, wi), to(kPoints);
  std::vector<double> found(kPoints), cosines(kPoints);
  std::array<double, kColatitudes> rows{};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const double step = (edge_[row + 1] - edge_[row]) / kAcross;
    for (std::size_t p = 0; p < kPoints; ++p) {
      const double down = edge_[row] + step * (static_cast<double>(p % kAcross) + 0.5);
      const std::size_t column = p / kAcross;
      const double azimuth = kPi * (static_cast<double>(column) + 0.5) / (kAzimuths * kAcross);
      to[p] = reflected(wi, down, azimuth);
      // cos(theta_o), and 4 h.wi by which a half-vector's solid angle becomes wo's: |wi + wo| / 2.
      cosines[p] = std::max(to[p][2], 0.0) * std::sqrt(2 + 2 * dot(wi, to[p]));
    }
    luminance(from, to, found);
    std::array<double, kAzimuths> masses{};
    for (std::size_t p = 0; p < kPoints; ++p)
      masses[p / (std::size_t{kAcross} * kAcross)] += found[p] * cosines[p] * step;
    rows[row] = cumulate(angles_[angle].azimuth[row], masses);
  }
  cumulate(angles_[angle].colatitude, rows);
}

TableSampling::Between TableSampling::angles_beside(double cos_i) {
  const double at = std::acos(std::clamp(cos_i, 0.0, 1.0)) / (kPi / 2) * (kAngles - 1);
  const double lower = std::min(std::floor(at), kAngles - 2.0);
  return {static_cast<std::size_t>(lower), at - lower};
}

Direction TableSampling::draw(const Direction& wi, double choice, double u, double v) const {
  const Between between = angles_beside(wi[2]);
  const bool mirrored = choice >= 0.5;
  const double rest = 2 * choice - (mirrored ? 1 : 0);
  const Angle& angle = angles_[between.lower + (rest < between.weight ? 1 : 0)];
  const Found row = find(angle.colatitude, u), column = find(angle.azimuth[row.cell], v);
  const double down = std::lerp(edge_[row.cell], edge_[row.cell + 1], row.place);
  const double azimuth = kPi / kAzimuths * (static_cast<double>(column.cell) + column.place);
  return reflected(wi, down, mirrored ? -azimuth : azimuth);
}

double TableSampling::mass(const Angle& angle, std::size_t row, std::size_t column) const {
  const double of_row = angle.colatitude[row + 1] - angle.colatitude[row];
  return of_row * (angle.azimuth[row][column + 1] - angle.azimuth[row][column]);
}

double TableSampling::density(const Direction& wi, const Direction& wo) const {
  if (!(wo[2] > 0)) return 0;
  const Direction h{wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]};
  const double across2 = h[0] * h[0] + h[1] * h[1], length2 = across2 + h[2] * h[2];
  if (!(length2 > 0)) return 0;
  const double length = std::sqrt(length2);
  const double down = across2 / (length * (length + h[2]));  // 1 - cos(theta_h)
  const auto above = std::upper_bound(edge_.begin() + 1, edge_.end() - 1, down);
  const auto row = static_cast<std::size_t>(above - edge_.begin()) - 1;
  const Tangent u(wi);
  const double azimuth = std::atan2(std::abs(u.x * h[1] - u.y * h[0]), u.x * h[0] + u.y * h[1]);
  const auto column =
      static_cast<std::size_t>(std::min(azimuth / kPi * kAzimuths, kAzimuths - 1.0));
  const Between between = angles_beside(wi[2]);
  const double mass_here = std::lerp(mass(angles_[between.lower], row, column),
                                     mass(angles_[between.lower + 1], row, column), between.weight);
  const double solid_angle = (edge_[row + 1] - edge_[row]) * (kPi / kAzimuths);
  // Half of it for each side; 4 h.wi = 2 |wi + wo|.
  return 0.5 * mass_here / (solid_angle * 2 * length);
}

}  // namespace gonio
