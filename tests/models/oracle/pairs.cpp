#include "models/oracle/pairs.h"

#include <cmath>
#include <numbers>
#include <random>

namespace gonio::testing {
namespace {

using Direction = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;

template <class T>
class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  std::vector<DirectionPair<T>> all() {
    repeat(PairKind::hemisphere, 2500, [this] { add(hemisphere(), hemisphere()); });
    repeat(PairKind::near_mirror, 3500, [this] { add_lobe(hemisphere()); });
    repeat(PairKind::grazing_lobe, 1000, [this] { add_lobe(grazing()); });
    repeat(PairKind::retro, 1200, [this] { add_retro(); });
    repeat(PairKind::grazing, 1000, [this] { add(grazing(), hemisphere()); });
    repeat(PairKind::grazing, 500, [this] { add(hemisphere(), grazing()); });
    repeat(PairKind::grazing, 500, [this] { add(grazing(), grazing()); });
    repeat(PairKind::exact_mirror, 400, [this] { add_exact_mirror(); });
    repeat(PairKind::opposite, 500, [this] { add_opposite(); });
    repeat(PairKind::across, 500, [this] { add_across(); });
    repeat(PairKind::tiny_z, 400, [this] { add_tiny_z(); });
    add_special();
    add_off_unit(1500);
    return std::move(pairs_);
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Every order of magnitude alike.
  double logarithmic(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }

  static Direction spherical(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
  }
  Direction hemisphere() { return spherical(std::acos(uniform(0, 1)), uniform(0, 2 * kPi)); }
  Direction grazing() {
    const double elevation = logarithmic(0.01, 10) * kPi / 180;
    return spherical(kPi / 2 - elevation, uniform(0, 2 * kPi));
  }

  template <class Body>
  void repeat(PairKind kind, int count, const Body& body) {
    kind_ = kind;
    for (int i = 0; i < count; ++i) body();
  }
  void add(const Direction& wi, const Direction& wo) {
    const auto rounded = [](const Direction& w) {
      return std::array<T, 3>{static_cast<T>(w[0]), static_cast<T>(w[1]), static_cast<T>(w[2])};
    };
    pairs_.push_back({rounded(wi), rounded(wo), kind_});
  }

  void add_lobe(const Direction& wi) {
    const Direction h = spherical(std::atan(logarithmic(1e-6, 1)), uniform(0, 2 * kPi));
    const double twice = 2 * (wi[0] * h[0] + wi[1] * h[1] + wi[2] * h[2]);
    add(wi, {twice * h[0] - wi[0], twice * h[1] - wi[1], twice * h[2] - wi[2]});
  }
  void add_retro() {
    Direction wi = uniform(0, 1) < 0.2 ? grazing() : hemisphere();
    const double theta = std::acos(wi[2]), phi = std::atan2(wi[1], wi[0]);
    const double off = logarithmic(1e-6, 0.1), turn = uniform(0, 2 * kPi);
    if (uniform(0, 1) < 0.05) return add(wi, wi);
    add(wi, spherical(theta + off * std::cos(turn), phi + off * std::sin(turn)));
  }
  void add_exact_mirror() {
    const Direction wi = uniform(0, 1) < 0.3 ? grazing() : hemisphere();
    add(wi, {-wi[0], -wi[1], wi[2]});
  }
  void add_opposite() {
    const double phi = uniform(0, 2 * kPi), off = logarithmic(1e-9, 1e-2);
    const Direction wi = spherical(kPi / 2 - logarithmic(1e-9, 1e-2), phi);
    Direction wo = spherical(kPi / 2 - logarithmic(1e-9, 1e-2), phi + kPi + off);
    if (uniform(0, 1) < 0.2) wo = {-wi[0], -wi[1], wo[2]};
    add(wi, wo);
  }
  void add_across() {
    const Direction wi = uniform(0, 1) < 0.2 ? grazing() : hemisphere(), any = hemisphere();
    const Direction mirrored{-wi[0], -wi[1], wi[2]};
    Direction wo{mirrored[1] * any[2] - mirrored[2] * any[1],
                 mirrored[2] * any[0] - mirrored[0] * any[2],
                 mirrored[0] * any[1] - mirrored[1] * any[0]};
    const double length = std::copysign(std::hypot(wo[0], wo[1], wo[2]), wo[2]);
    for (double& component : wo) component /= length;
    add(wi, wo);
  }
  // Down to the smallest denormal float32, for T = double too.
  double tiny() {
    constexpr std::array<double, 5> kTiny{1e-12, 1e-30, 1e-38, 1e-39, 1.4e-45};
    return kTiny[random_() % kTiny.size()];
  }
  void add_tiny_z() {
    Direction wi = spherical(kPi / 2, uniform(0, 2 * kPi));
    Direction wo = uniform(0, 1) < 0.4 ? spherical(kPi / 2, uniform(0, 2 * kPi)) : hemisphere();
    wi[2] = tiny();
    if (std::abs(wo[2]) < 1e-9) wo[2] = tiny();
    if (uniform(0, 1) < 0.2) wo = Direction{-wi[0], -wi[1], tiny()};
    if (uniform(0, 1) < 0.5) std::swap(wi, wo);
    add(wi, wo);
  }
  void add_special() {
    kind_ = PairKind::special;
    std::vector<Direction> directions{{0, 0, 1}};
    for (const double theta : {1e-6, 0.3, kPi / 4, 1.0, 1.5, 89.99 * kPi / 180}) {
      for (int octant = 0; octant < 4; ++octant) {
        const double x = octant == 0 ? 1 : octant == 2 ? -1 : 0;
        const double y = octant == 1 ? 1 : octant == 3 ? -1 : 0;
        directions.push_back({x * std::sin(theta), y * std::sin(theta), std::cos(theta)});
      }
    }
    for (const Direction& wi : directions) {
      for (const Direction& wo : directions) add(wi, wo);
    }
  }
  void add_off_unit(std::size_t count) {
    const std::size_t unit_pairs = pairs_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const auto& from = pairs_[random_() % unit_pairs];
      const double si = 1 + uniform(-9e-4, 9e-4), so = 1 + uniform(-9e-4, 9e-4);
      const auto scaled = [](const std::array<T, 3>& w, double s) {
        return Direction{static_cast<double>(w[0]) * s, static_cast<double>(w[1]) * s,
                         static_cast<double>(w[2]) * s};
      };
      kind_ = PairKind::off_unit;
      add(scaled(from.wi, si), scaled(from.wo, so));
    }
  }

  std::mt19937_64 random_;
  PairKind kind_ = PairKind::hemisphere;
  std::vector<DirectionPair<T>> pairs_;
};

}  // namespace

std::string_view name_of(PairKind kind) {
  constexpr std::array<std::string_view, kPairKinds> kNames{
      "hemisphere", "near mirror", "grazing lobe", "retro",   "grazing", "exact mirror",
      "opposite",   "tiny z",      "across",       "special", "off unit"};
  return kNames.at(static_cast<std::size_t>(kind));
}

template <class T>
std::vector<DirectionPair<T>> hard_pairs(std::uint64_t seed) {
  return Generator<T>(seed).all();
}

template std::vector<DirectionPair<float>> hard_pairs(std::uint64_t);
template std::vector<DirectionPair<double>> hard_pairs(std::uint64_t);

}  // namespace gonio::testing
