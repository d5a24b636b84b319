#include "client/picture/lobe/scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace gonio::lobe {
namespace {

constexpr double kNothing = 1e-60;  // of the end: what a logarithm shows in the place of 0

// 1, 2 or 5 times a power of ten, not below `value`.
double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (value <= digit * power * (1 + 1e-9)) return digit * power;
  }
  return 10 * power;
}

std::string superscript(int number) {
  constexpr std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                   "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) {
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

// Plain where that is short, else with a power of ten.
std::string label(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  std::array<char, 32> text{};
  if (exponent >= -3 && exponent <= 4) {
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
  }
  std::snprintf(text.data(), text.size(), "%.3g", value / std::pow(10, exponent));
  const std::string digits = text.data();
  return (digits == "1" ? "" : digits + "·") + "10" + superscript(exponent);
}

}  // namespace

Scale::Scale(ScaleKind kind, double least, double most) : kind_(kind) {
  const double top = std::clamp(most, 1e-30, double{std::numeric_limits<float>::max()});
  if (kind != ScaleKind::log) {
    end_ = rounded_up(top);
    return;
  }
  const double exponent = std::ceil(std::log10(top) - 1e-9);
  end_ = std::pow(10, exponent);
  decades_ = std::clamp(exponent - std::floor(std::log10(std::clamp(least, 1e-30, top))),
                        kFewestDecades, kMostDecades);
}

double Scale::position(double value) const {
  if (!(value > 0)) return 0;
  const double part = std::min(value / end_, 1.0);
  switch (kind_) {
    case ScaleKind::linear:
      return part;
    case ScaleKind::cbrt:
      return std::cbrt(part);
    case ScaleKind::log:
      break;
  }
  return std::max(0.0, 1 + std::log10(part) / decades_);
}

double Scale::unbounded_position(double value) const {
  const double part = value / end_;
  if (kind_ == ScaleKind::linear) return part;
  if (kind_ == ScaleKind::cbrt) return std::cbrt(part);
  return 1 + std::log10(std::max(part, kNothing)) / decades_;
}

std::vector<Tick> Scale::ticks() const {
  std::vector<Tick> ticks;
  const auto add = [&](double value) { ticks.push_back({position(value), label(value)}); };
  if (kind_ == ScaleKind::log) {
    for (double i = decades_ - 1; i >= 0; --i) add(end_ * std::pow(10, -i));
  } else if (kind_ == ScaleKind::linear) {
    for (const double part : {0.25, 0.5, 0.75, 1.0}) add(part * end_);
  } else {
    for (const double part : {0.01, 0.1, 0.3, 1.0}) add(part * end_);
  }
  return ticks;
}

}  // namespace gonio::lobe
