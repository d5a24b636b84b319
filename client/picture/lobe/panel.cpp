#include "client/picture/lobe/panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "client/picture/lobe/colours.h"
#include "client/picture/render/geometry.h"

namespace gonio::lobe {
namespace {

using render::radians;
using std::numbers::pi;

constexpr std::array<Colour, 3> kChannels = {
    {{0.90, 0.18, 0.18, 1}, {0.15, 0.65, 0.22, 1}, {0.15, 0.38, 0.92, 1}}};

// theta_o from the vertical, positive to the right.
Spot polar(Spot centre, double theta, double radius) {
  return {centre.x + radius * std::sin(radians(theta)),
          centre.y - radius * std::cos(radians(theta))};
}

std::string degrees(double angle) { return std::to_string(std::lround(angle)) + "°"; }

void draw_grid(Canvas& canvas, Spot centre, const Style& style, const Scale& scale) {
  const Pen thin{kFaint, 0.7 * style.line()};
  for (const double theta : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
    canvas.line(std::array{centre, polar(centre, theta, style.radius)}, thin);
    canvas.text(polar(centre, theta, style.radius + 0.9 * style.text()), degrees(std::abs(theta)),
                0.8 * style.text(), Align::centre, kInk);
  }
  for (const Tick& tick : scale.ticks()) {
    const double r = tick.position * style.radius;
    canvas.arc(centre, r, 0, pi, thin);
    if (r < 0.1 * style.radius) continue;  // no room for its label
    canvas.text({centre.x + r, centre.y + 0.8 * style.text()}, tick.label, 0.72 * style.text(),
                Align::centre, kInk);
  }
  const Spot left{centre.x - style.radius, centre.y}, right{centre.x + style.radius, centre.y};
  canvas.line(std::array{left, right}, {kInk, style.line()});
}

// The incident ray, with its head at the surface, and where a mirror would send it.
void draw_rays(Canvas& canvas, Spot centre, const Style& style, double theta_i) {
  canvas.line(std::array{centre, polar(centre, theta_i, style.radius)},
              {{0.45, 0.45, 0.5, 1}, 0.9 * style.line(), true});
  canvas.line(std::array{polar(centre, -theta_i, style.radius),
                         polar(centre, -theta_i, 0.06 * style.radius)},
              {kLight, 1.6 * style.line()});
  const double head = 0.09 * style.radius;
  const Spot middle = polar(centre, -theta_i, head);
  const Spot across{std::cos(radians(-theta_i)), std::sin(radians(-theta_i))};
  canvas.area(
      std::array{centre, Spot{middle.x + 0.35 * head * across.x, middle.y + 0.35 * head * across.y},
                 Spot{middle.x - 0.35 * head * across.x, middle.y - 0.35 * head * across.y}},
      kLight);
}

}  // namespace

void draw_polar(Canvas& canvas, Spot centre, const Style& style, const Scale& scale,
                const Incidence& incidence, const Curve& curve, int channels) {
  draw_grid(canvas, centre, style, scale);
  draw_rays(canvas, centre, style, incidence.theta_i);
  for (int channel = 0; channel < channels; ++channel) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
      const double r = style.radius * scale.position(curve.values[i][channel]);
      spots.push_back(polar(centre, curve.theta_o[i], r));
    }
    const Colour colour = channels == 1 ? kInk : kChannels[static_cast<std::size_t>(channel)];
    canvas.area(spots, {colour.red, colour.green, colour.blue, 0.10});
    canvas.line(spots, {colour, 1.4 * style.line(), false, true});
  }
}

void draw_hemisphere(Canvas& canvas, Spot centre, const Style& style, const Scale& scale,
                     const Incidence& incidence, int side, std::span<const image::Rgb> pixels) {
  std::vector<Colour> colours;
  for (const image::Rgb& value : pixels) {
    colours.push_back(false_colour(scale.position(image::luminance(value))));
  }
  const int left = static_cast<int>(std::lround(centre.x - side / 2.0));
  const int top = static_cast<int>(std::lround(centre.y - side / 2.0));
  canvas.disc(left, top, side, colours);
  const Spot middle{left + side / 2.0, top + side / 2.0};
  const double radius = side / 2.0;
  const Pen thin{{1, 1, 1, 0.25}, 0.6 * style.line()};
  for (const double theta : {30.0, 60.0}) {
    canvas.arc(middle, radius * std::sin(radians(theta)), 0, 2 * pi, thin);
  }
  canvas.arc(middle, radius, 0, 2 * pi, {kInk, style.line()});
  // The light to the left, a mirror's direction to the right.
  const double reach = radius * std::sin(radians(incidence.theta_i));
  const double dot = 0.028 * radius;
  canvas.arc({middle.x - reach, middle.y}, dot, 0, 2 * pi, {kLight, 1.8 * style.line()});
  canvas.arc({middle.x + reach, middle.y}, dot, 0, 2 * pi, {{1, 1, 1, 0.9}, style.line()});
  // The axis to the right has the azimuth phi_i + 180 degrees.
  for (const auto& [name, azimuth] : {std::pair{"u", 0.0}, std::pair{"v", 90.0}}) {
    const double angle = radians(azimuth - incidence.phi_i - 180);
    const double x = std::cos(angle), y = -std::sin(angle), outer = radius + 0.35 * style.text();
    canvas.line(std::array{Spot{middle.x + radius * x, middle.y + radius * y},
                           Spot{middle.x + outer * x, middle.y + outer * y}},
                {kInk, style.line()});
    const double away = radius + 0.95 * style.text();
    canvas.text({middle.x + away * x, middle.y + away * y}, name, 0.9 * style.text(), Align::centre,
                kInk);
  }
}

void draw_bar(Canvas& canvas, Spot bottom, double height, const Style& style, const Scale& scale) {
  const double width = 1.3 * style.text();
  const int steps = std::max(1, static_cast<int>(height));
  for (int i = 0; i < steps; ++i) {
    const double low = bottom.y - height * i / steps;
    // A little more than a step, so that no seam shows.
    const double high = std::max(bottom.y - height * (i + 1.5) / steps, bottom.y - height);
    canvas.area(std::array{Spot{bottom.x, low}, Spot{bottom.x + width, low},
                           Spot{bottom.x + width, high}, Spot{bottom.x, high}},
                false_colour((i + 0.5) / steps));
  }
  for (const Tick& tick : scale.ticks()) {
    const double y = bottom.y - height * tick.position;
    const double end = bottom.x + width;
    canvas.line(std::array{Spot{end, y}, Spot{end + 0.3 * style.text(), y}},
                {kInk, 0.7 * style.line()});
    canvas.text({end + 0.5 * style.text(), y}, tick.label, 0.8 * style.text(), Align::left, kInk);
  }
}

}  // namespace gonio::lobe
