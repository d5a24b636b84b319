#include "client/picture/lobe/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "client/picture/lobe/canvas.h"
#include "client/picture/lobe/lobe.h"
#include "client/picture/lobe/panel.h"

namespace gonio::lobe {
namespace {

struct Lobe {
  Incidence incidence;
  Curve curve;
  std::vector<image::Rgb> hemisphere;
};

// Where things stand, in units of the radius.
constexpr double kColumn = 2.45, kBarColumn = 0.75, kTitle = 0.30, kHeading = 0.42, kBetween = 0.32,
                 kBelow = 0.22, kHeight = kTitle + kHeading + 1 + kBetween + 2 + kBelow;

struct Layout {
  Layout(const PictureOptions& options)  // NOLINT(google-explicit-constructor): inside this file
      : style{std::min(
            options.width / (kColumn * static_cast<double>(options.theta_i.size()) + kBarColumn),
            options.height / kHeight)},
        side(std::max(1, static_cast<int>(2 * style.radius))) {
    const double r = style.radius;
    left =
        (options.width - r * (kColumn * static_cast<double>(options.theta_i.size()) + kBarColumn)) /
        2;
    top = (options.height - r * kHeight) / 2;
  }

  [[nodiscard]] double column(std::size_t i) const {
    return left + style.radius * kColumn * (static_cast<double>(i) + 0.5);
  }
  [[nodiscard]] double polar_y() const { return top + style.radius * (kTitle + kHeading + 1); }
  [[nodiscard]] double disc_y() const { return polar_y() + style.radius * (kBetween + 1); }

  Style style;
  int side;
  double left = 0, top = 0;
};

Result<std::vector<Lobe>> evaluate_lobes(const PictureOptions& options, int side,
                                         render::Evaluator& evaluator) {
  std::vector<Lobe> lobes;
  for (const double theta : options.theta_i) {
    const Incidence incidence{theta, options.phi_i, options.cosine};
    auto curve = curve_of(incidence, evaluator);
    if (!curve) return curve.error();
    auto hemisphere = hemisphere_of(incidence, side, evaluator);
    if (!hemisphere) return hemisphere.error();
    lobes.push_back({incidence, std::move(curve).value(), std::move(hemisphere).value()});
  }
  return lobes;
}

// One for all lobes, so that they can be compared.
Scale common_scale(ScaleKind kind, const std::vector<Lobe>& lobes) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Lobe& lobe : lobes) {
    for (const auto* values : {&lobe.curve.values, &lobe.hemisphere}) {
      for (const image::Rgb& value : *values) {
        most = std::max(most, double{value.maxCoeff()});
        if (image::luminance(value) > 0) least = std::min(least, double{image::luminance(value)});
      }
    }
  }
  if (!(most > 0)) return {kind, 1, 1};  // black: any scale shows it
  return {kind, least, most};
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

void draw_title(Canvas& canvas, const Layout& layout, const PictureOptions& options) {
  const double size = layout.style.text();
  const double y = layout.top + layout.style.radius * kTitle / 2 + 0.2 * size;
  const char* const scales[] = {"log", "linear", "cube root"};
  const std::string what = std::string(options.cosine ? "f cos θₒ" : "f") + " in 1/sr, " +
                           scales[static_cast<int>(options.scale)] +
                           ",  φᵢ = " + number(options.phi_i) + "°";
  const double margin = layout.left + 0.1 * layout.style.radius;
  const double right = options.width - margin;
  canvas.text({right, y}, what, size, Align::right, kInk);
  const double room = right - margin - canvas.text_width(what, size) - 2 * size;
  canvas.text({margin, y}, canvas.shortened(options.title, size, room), size, Align::left, kInk);
}

}  // namespace

Result<std::vector<std::uint8_t>> draw_lobes(const PictureOptions& options,
                                             render::Evaluator& evaluator) {
  const Layout layout(options);
  auto lobes = evaluate_lobes(options, layout.side, evaluator);
  if (!lobes) return lobes.error();
  const Scale scale = common_scale(options.scale, *lobes);
  const Style& style = layout.style;
  Canvas canvas(options.width, options.height);
  draw_title(canvas, layout, options);
  for (std::size_t i = 0; i < lobes->size(); ++i) {
    const Lobe& lobe = (*lobes)[i];
    const double x = layout.column(i);
    canvas.text({x, layout.top + style.radius * (kTitle + 0.14)},
                "θᵢ = " + number(lobe.incidence.theta_i) + "°", 1.15 * style.text(), Align::centre,
                kInk);
    draw_polar(canvas, {x, layout.polar_y()}, style, scale, lobe.incidence, lobe.curve,
               evaluator.channels());
    draw_hemisphere(canvas, {x, layout.disc_y()}, style, scale, lobe.incidence, layout.side,
                    lobe.hemisphere);
  }
  const Spot bar{layout.column(lobes->size()) - style.radius * (kColumn / 2 - 0.08),
                 layout.disc_y() + 0.9 * style.radius};
  draw_bar(canvas, bar, 1.8 * style.radius, style, scale);
  return canvas.rgb();
}

}  // namespace gonio::lobe
