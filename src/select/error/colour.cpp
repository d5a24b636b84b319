#include "select/error/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio::select {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

// From linear sRGB to X, Y and Z relative to white: each row sums to 1.
constexpr double kFromRgb[3][3] = {{0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505},
                                   {0.2126, 0.7152, 0.0722},
                                   {0.0193 / 1.0890, 0.1192 / 1.0890, 0.9505 / 1.0890}};

// The cube root, and near black the tangent that continues it.
double lightness(double t) {
  constexpr double kKnee = 6.0 / 29;
  return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4.0 / 29;
}

double seventh(double chroma) {
  const double c = std::pow(chroma, 7);
  return std::sqrt(c / (c + std::pow(25.0, 7)));
}

// In [0, 2 pi); 0 for grey.
double hue(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double angle = std::atan2(b, a);
  return angle < 0 ? angle + 2 * kPi : angle;
}

struct Hues {
  double difference, mean;
};

// The difference the shorter way round. The hue of a grey is undefined and gives 0.
Hues between(double x, double y, bool grey) {
  if (grey) return {0, x + y};
  const double sum = x + y, step = y - x;
  if (std::abs(step) <= kPi) return {step, sum / 2};
  return {step > 0 ? step - 2 * kPi : step + 2 * kPi,
          (sum < 2 * kPi ? sum + 2 * kPi : sum - 2 * kPi) / 2};
}

}  // namespace

Lab lab_of(double red, double green, double blue) {
  const std::array rgb{std::clamp(red, 0.0, 1.0), std::clamp(green, 0.0, 1.0),
                       std::clamp(blue, 0.0, 1.0)};
  std::array<double, 3> f{};
  for (std::size_t i = 0; i < 3; ++i)
    f[i] = lightness(kFromRgb[i][0] * rgb[0] + kFromRgb[i][1] * rgb[1] + kFromRgb[i][2] * rgb[2]);
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double delta_e(const Lab& x, const Lab& y) {
  // Stretches a for colours near grey.
  const double stretch = 1.5 - seventh((std::hypot(x.a, x.b) + std::hypot(y.a, y.b)) / 2) / 2;
  const double ax = stretch * x.a, ay = stretch * y.a;
  const double cx = std::hypot(ax, x.b), cy = std::hypot(ay, y.b);
  const Hues hues = between(hue(ax, x.b), hue(ay, y.b), cx * cy == 0);
  const double chroma = (cx + cy) / 2, h = hues.mean;
  const double weight = 1 - 0.17 * std::cos(h - 30 * kDegree) + 0.24 * std::cos(2 * h) +
                        0.32 * std::cos(3 * h + 6 * kDegree) - 0.2 * std::cos(4 * h - 63 * kDegree);
  const double from_middle = (x.l + y.l) / 2 - 50, square = from_middle * from_middle;
  const double dl = (y.l - x.l) / (1 + 0.015 * square / std::sqrt(20 + square));
  const double dc = (cy - cx) / (1 + 0.045 * chroma);
  const double dh =
      2 * std::sqrt(cx * cy) * std::sin(hues.difference / 2) / (1 + 0.015 * chroma * weight);
  const double turn = (h / kDegree - 275) / 25;
  const double rotation = -2 * seventh(chroma) * std::sin(60 * kDegree * std::exp(-turn * turn));
  return std::sqrt(std::max(dl * dl + dc * dc + dh * dh + rotation * dc * dh, 0.0));
}

}  // namespace gonio::select
