// Drawing with cairo: anti-aliased lines, areas and text on white. Lengths are in pixels from the
// upper left corner. Thread safety: used by one thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gonio/base/result.h"

struct _cairo;  // NOLINT(bugprone-reserved-identifier): theirs

namespace gonio::lobe {

struct Colour {
  double red = 0, green = 0, blue = 0, alpha = 1;
};

struct Spot {
  double x = 0, y = 0;
};

struct Pen {
  Colour colour;
  double width = 1;
  bool dashed = false;
  bool multiplied = false;  // darkens what is below: lines of several colours become black
};

enum class Align : std::uint8_t { left, centre, right };

class Canvas {
 public:
  Canvas(int width, int height);

  void line(std::span<const Spot> spots, const Pen& pen);
  void area(std::span<const Spot> spots, const Colour& colour);
  // Counter-clockwise as seen, angles in radians from +x; 0 and 2 pi for a circle.
  void arc(Spot centre, double radius, double from, double to, const Pen& pen);
  // At half the height of a capital letter, `at` is the left, middle or right of the text.
  void text(Spot at, const std::string& words, double size, Align align, const Colour& colour);
  [[nodiscard]] double text_width(const std::string& words, double size);
  // `words`, or as many of them as have room, and then an ellipsis.
  [[nodiscard]] std::string shortened(const std::string& words, double size, double width);
  // A picture of three bytes a pixel, row by row, its upper left corner at a whole pixel.
  void picture(int left, int top, int width, std::span<const std::uint8_t> rgb);
  // A filled circle.
  void dot(Spot centre, double radius, const Colour& colour);
  // Until the next call, nothing is drawn outside of the rectangle; without one, everything is.
  void clip(const std::optional<std::array<Spot, 2>>& corners);
  // A square of side x side pixels, its upper left corner at a whole pixel; only the circle in it
  // is painted.
  void disc(int left, int top, int side, std::span<const Colour> pixels);

  // Three bytes a pixel, row by row. Errors: what cairo says.
  Result<std::vector<std::uint8_t>> rgb();

 private:
  struct Free {
    void operator()(_cairo* context) const;
  };
  void path(std::span<const Spot> spots);
  void stroke(const Pen& pen);
  void font(double size);

  std::unique_ptr<_cairo, Free> context_;
};

}  // namespace gonio::lobe
