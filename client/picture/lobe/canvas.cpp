#include "client/picture/lobe/canvas.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio::lobe {
namespace {

std::uint32_t packed(const Colour& colour) {
  const auto byte = [](double value) {
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  return (byte(colour.red) << 16U) | (byte(colour.green) << 8U) | byte(colour.blue);
}

}  // namespace

void Canvas::Free::operator()(_cairo* context) const { cairo_destroy(context); }

Canvas::Canvas(int width, int height) {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  context_.reset(cairo_create(surface));
  cairo_surface_destroy(surface);  // the context keeps it
  cairo_set_source_rgb(context_.get(), 1, 1, 1);
  cairo_paint(context_.get());
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::path(std::span<const Spot> spots) {
  cairo_new_path(context_.get());
  for (const Spot& spot : spots) cairo_line_to(context_.get(), spot.x, spot.y);
}

void Canvas::stroke(const Pen& pen) {
  const Colour& c = pen.colour;
  cairo_set_source_rgba(context_.get(), c.red, c.green, c.blue, c.alpha);
  cairo_set_line_width(context_.get(), pen.width);
  const std::array<double, 2> dashes = {4 * pen.width, 3 * pen.width};
  cairo_set_dash(context_.get(), dashes.data(), pen.dashed ? 2 : 0, 0);
  cairo_set_operator(context_.get(),
                     pen.multiplied ? CAIRO_OPERATOR_MULTIPLY : CAIRO_OPERATOR_OVER);
  cairo_stroke(context_.get());
  cairo_set_operator(context_.get(), CAIRO_OPERATOR_OVER);
}

void Canvas::line(std::span<const Spot> spots, const Pen& pen) {
  path(spots);
  stroke(pen);
}

void Canvas::area(std::span<const Spot> spots, const Colour& colour) {
  path(spots);
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, colour.alpha);
  cairo_fill(context_.get());
}

void Canvas::arc(Spot centre, double radius, double from, double to, const Pen& pen) {
  cairo_new_path(context_.get());
  // Cairo's y axis points down, and with it its angles.
  cairo_arc_negative(context_.get(), centre.x, centre.y, radius, -from, -to);
  stroke(pen);
}

void Canvas::font(double size) {
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), size);
}

double Canvas::text_width(const std::string& words, double size) {
  font(size);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), words.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(Spot at, const std::string& words, double size, Align align,
                  const Colour& colour) {
  const double width = text_width(words, size);
  const double left = align == Align::left ? 0 : align == Align::centre ? width / 2 : width;
  constexpr double kHalfCapital = 0.36;  // of DejaVu's size
  cairo_move_to(context_.get(), at.x - left, at.y + kHalfCapital * size);
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, colour.alpha);
  cairo_show_text(context_.get(), words.c_str());
}

// Shortened in the middle of UTF-8 only between its characters.
std::string Canvas::shortened(const std::string& words, double size, double width) {
  if (text_width(words, size) <= width) return words;
  std::string text = words;
  while (!text.empty() && text_width(text + "…", size) > width) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) {
      text.pop_back();
    }
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

void Canvas::picture(int left, int top, int width, std::span<const std::uint8_t> rgb) {
  std::vector<std::uint32_t> pixels;
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
    pixels.push_back((std::uint32_t{rgb[i]} << 16U) | (std::uint32_t{rgb[i + 1]} << 8U) |
                     std::uint32_t{rgb[i + 2]});
  }
  const int height = static_cast<int>(pixels.size()) / width;
  cairo_surface_t* source = cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(pixels.data()), CAIRO_FORMAT_RGB24, width, height,
      static_cast<int>(sizeof(std::uint32_t)) * width);
  cairo_set_source_surface(context_.get(), source, left, top);
  cairo_rectangle(context_.get(), left, top, width, height);
  cairo_fill(context_.get());
  cairo_surface_destroy(source);
}

void Canvas::dot(Spot centre, double radius, const Colour& colour) {
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, colour.alpha);
  cairo_fill(context_.get());
}

void Canvas::clip(const std::optional<std::array<Spot, 2>>& corners) {
  cairo_reset_clip(context_.get());
  if (!corners) return;
  const auto& [from, to] = *corners;
  cairo_rectangle(context_.get(), from.x, from.y, to.x - from.x, to.y - from.y);
  cairo_clip(context_.get());
}

void Canvas::disc(int left, int top, int side, std::span<const Colour> pixels) {
  std::vector<std::uint32_t> packed_pixels(pixels.size());
  std::transform(pixels.begin(), pixels.end(), packed_pixels.begin(), packed);
  cairo_surface_t* square = cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(packed_pixels.data()), CAIRO_FORMAT_RGB24, side, side,
      static_cast<int>(sizeof(std::uint32_t)) * side);
  cairo_set_source_surface(context_.get(), square, left, top);
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), left + side / 2.0, top + side / 2.0, side / 2.0, 0,
            2 * std::numbers::pi);
  cairo_fill(context_.get());
  cairo_surface_destroy(square);
}

Result<std::vector<std::uint8_t>> Canvas::rgb() {
  cairo_surface_t* surface = cairo_get_target(context_.get());
  cairo_surface_flush(surface);
  if (const cairo_status_t status = cairo_status(context_.get()); status != CAIRO_STATUS_SUCCESS) {
    const std::string why = cairo_status_to_string(status);
    return Error{ErrorCode::internal, "the picture cannot be drawn: " + why, {}, {}, {}};
  }
  const int width = cairo_image_surface_get_width(surface);
  const unsigned char* row = cairo_image_surface_get_data(surface);
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < cairo_image_surface_get_height(surface); ++y) {
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(row);
    for (int x = 0; x < width; ++x) {
      for (const unsigned shift : {16U, 8U, 0U}) {
        bytes.push_back(static_cast<std::uint8_t>(pixels[x] >> shift));
      }
    }
    row += cairo_image_surface_get_stride(surface);
  }
  return bytes;
}

}  // namespace gonio::lobe
