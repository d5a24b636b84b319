#include "client/picture/lobe/slices.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "client/picture/lobe/panel.h"
#include "client/picture/lobe/scale.h"

namespace gonio::lobe {
namespace {

// Colours that the colour-blind tell apart (Okabe and Ito 2008).
constexpr std::array<Colour, 6> kColours = {{{0.00, 0.45, 0.70, 1},
                                             {0.84, 0.37, 0.00, 1},
                                             {0.00, 0.62, 0.45, 1},
                                             {0.80, 0.47, 0.65, 1},
                                             {0.90, 0.62, 0.00, 1},
                                             {0.34, 0.71, 0.91, 1}}};
constexpr Colour kDot{0.25, 0.25, 0.28, 0.55};
constexpr double kText = 14, kSmall = 12;
// Around all panels, and around each of them.
constexpr double kHead = 64, kFoot = 34, kLeft = 52, kAbove = 26, kBelow = 24, kBeside = 18;

Pen pen_of(std::size_t material) {
  return {kColours[material % kColours.size()], 2, material >= kColours.size()};
}

// The least and the most of the positive values.
struct Range {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  void take(double value) {
    if (!(value > 0) || std::isinf(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

// From the least to the most of what is measured in a column, and a decade more at each end where
// lines go beyond it and there is room: a fit that is wrong by more leaves the frame, and all that
// is measured keeps its place.
Scale scale_of(const std::vector<SlicePanel>& panels, std::size_t column, std::size_t columns) {
  Range measured, lines;
  for (std::size_t i = column; i < panels.size(); i += columns) {
    for (const Spot& spot : panels[i].measured) measured.take(spot.y);
    for (const auto& line : panels[i].lines) {
      for (const double value : line) lines.take(value);
    }
  }
  if (measured.most == 0) measured = lines;
  if (measured.most == 0) return {ScaleKind::log, 0.01, 1};
  double top = std::ceil(std::log10(measured.most) - 1e-9);
  double bottom = std::floor(std::log10(measured.least));
  const auto room = [&] { return top - bottom + 1 <= Scale::kMostDecades; };
  if (room() && std::log10(lines.most) > top) ++top;
  if (room() && std::log10(lines.least) < bottom) --bottom;
  return {ScaleKind::log, std::pow(10, bottom), std::pow(10, top)};
}

// Where a panel's axes are, and what lies where between them.
struct Frame {
  double left, top, right, bottom;
  [[nodiscard]] double x(double theta) const { return left + (right - left) * (theta + 90) / 180; }
  [[nodiscard]] double y(double position) const { return bottom - (bottom - top) * position; }
};

void draw_axes(Canvas& canvas, const Frame& frame, const Scale& scale, double theta_i) {
  const Pen thin{kFaint, 1};
  for (int theta = -90; theta <= 90; theta += 30) {
    const double x = frame.x(theta);
    canvas.line(std::array{Spot{x, frame.top}, Spot{x, frame.bottom}}, thin);
    canvas.text({x, frame.bottom + 0.9 * kSmall}, std::to_string(theta) + "°", kSmall,
                Align::centre, kInk);
  }
  for (const Tick& tick : scale.ticks()) {
    const double y = frame.y(tick.position);
    canvas.line(std::array{Spot{frame.left, y}, Spot{frame.right, y}}, thin);
    canvas.text({frame.left - 6, y}, tick.label, kSmall, Align::right, kInk);
  }
  const double light = frame.x(-theta_i), mirror = frame.x(theta_i);
  canvas.line(std::array{Spot{light, frame.top}, Spot{light, frame.bottom}}, {kLight, 1.5, true});
  canvas.line(std::array{Spot{mirror, frame.top}, Spot{mirror, frame.bottom}},
              {{0.45, 0.45, 0.5, 1}, 1.5, true});
  canvas.line(std::array{Spot{frame.left, frame.top}, Spot{frame.left, frame.bottom},
                         Spot{frame.right, frame.bottom}},
              {kInk, 1.2});
}

void draw_panel(Canvas& canvas, const Frame& frame, const Scale& scale, const SlicePanel& panel) {
  draw_axes(canvas, frame, scale, panel.theta_i);
  char angle[32];
  std::snprintf(angle, sizeof(angle), "θᵢ = %.4g°", panel.theta_i);
  canvas.text({frame.left, frame.top - 0.8 * kText},
              angle + (panel.channel.empty() ? "" : ", " + panel.channel), kText, Align::left,
              kInk);
  canvas.text({frame.right, frame.top - 0.8 * kText}, "f in 1/sr", kSmall, Align::right, kInk);
  canvas.clip(std::array{Spot{frame.left, frame.top}, Spot{frame.right, frame.bottom}});
  for (const Spot& spot : panel.measured) {
    if (spot.y > 0)
      canvas.dot({frame.x(spot.x), frame.y(scale.unbounded_position(spot.y))}, 2.2, kDot);
  }
  for (std::size_t line = 0; line < panel.lines.size(); ++line) {
    std::vector<Spot> spots;
    for (std::size_t i = 0; i < panel.theta_o.size(); ++i) {
      const double position = scale.unbounded_position(panel.lines[line][i]);
      spots.push_back({frame.x(panel.theta_o[i]), frame.y(position)});
    }
    canvas.line(spots, pen_of(line));
  }
  canvas.clip(std::nullopt);
}

void draw_head(Canvas& canvas, const SlicesPicture& picture) {
  const double room = picture.width - 2 * kBeside;
  canvas.text({kBeside, 18}, canvas.shortened(picture.title, 1.15 * kText, room), 1.15 * kText,
              Align::left, kInk);
  const double each = room / static_cast<double>(picture.materials.size() + 1);
  canvas.dot({kBeside + 8, 44}, 3.2, kDot);
  canvas.text({kBeside + 20, 44}, canvas.shortened("measured", kText, each - 30), kText,
              Align::left, kInk);
  for (std::size_t i = 0; i < picture.materials.size(); ++i) {
    const double left = kBeside + each * static_cast<double>(i + 1);
    canvas.line(std::array{Spot{left, 44}, Spot{left + 24, 44}}, pen_of(i));
    canvas.text({left + 30, 44}, canvas.shortened(picture.materials[i], kText, each - 40), kText,
                Align::left, kInk);
  }
}

}  // namespace

Result<std::vector<std::uint8_t>> draw_slices(const SlicesPicture& picture,
                                              const std::vector<SlicePanel>& panels) {
  Canvas canvas(picture.width, picture.height);
  draw_head(canvas, picture);
  const std::size_t rows = (panels.size() + picture.columns - 1) / picture.columns;
  const double width = picture.width / static_cast<double>(picture.columns);
  const double height = (picture.height - kHead - kFoot) / static_cast<double>(rows);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::size_t column = i % picture.columns;
    const double left = width * static_cast<double>(column);
    const std::size_t row = i / picture.columns;
    const double top = kHead + height * static_cast<double>(row);
    draw_panel(canvas, {left + kLeft, top + kAbove, left + width - kBeside, top + height - kBelow},
               scale_of(panels, column, picture.columns), panels[i]);
  }
  const auto foot = [&](double line, const char* words) {
    canvas.text({picture.width / 2.0, picture.height - kFoot + line * 1.3 * kSmall}, words, kSmall,
                Align::centre, kInk);
  };
  foot(
      0.6,
      "θₒ in the plane of incidence, negative on the side of the light; dashed: the light (orange) "
      "and the mirror direction (grey)");
  foot(1.6, "a line that leaves the frame is beyond its range there");
  return canvas.rgb();
}

}  // namespace gonio::lobe
