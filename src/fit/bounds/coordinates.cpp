#include "fit/bounds/coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/linear/basis.h"

namespace gonio::fit {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// What rounding may move a colour by.
constexpr double kRounding = 1e-12;

void set_coefficients(const FormLobe& lobe, const Colour& colour, std::span<const double> peaks,
                      double* x) {
  const auto relative = coefficients_of(lobe.colours.columns, colour);
  for (std::size_t k = 0; k < lobe.coefficient_count; ++k)
    x[k] = relative[k] * peaks[lobe.first_column + k];
}

bool is_beyond(const FormLobe& lobe, const ColourBounds& bounds, const Colour& colour) {
  const auto members = lobe.colours.members();
  return std::any_of(members.begin(), members.end(), [&](ColourMember member) {
    const double x = colour.*member;
    return x > bounds.upper.*member * (1 + kRounding) || x < bounds.lower.*member * (1 - kRounding);
  });
}

// A reflectance has two coefficients, each with a bound of its own at 0.
bool is_near(const FormLobe& lobe, const ColourBounds& bounds, const Colour& colour, double near) {
  return colour.scale > near * bounds.upper.scale ||
         (lobe.coefficient_count > 2 && colour.diffuse > near * bounds.upper.diffuse);
}

}  // namespace

std::vector<double> within_bounds(const Form& form, std::span<const double> parameters,
                                  int channels) {
  std::vector<double> moved(parameters.begin(), parameters.end());
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    moved[i] = std::clamp(moved[i], shape.scale.to_search(shape.lower),
                          shape.scale.to_search(shape.upper));
  }
  const BasisAt at(form, std::span(moved).first(form.shapes.size()), false);
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
    for (const FormLobe& lobe : form.lobes) {
      const std::span x = std::span(moved).subspan(form.first_of(lobe, c), lobe.coefficient_count);
      for (double& coefficient : x) coefficient = std::max(coefficient, 0.0);
      const ColourBounds bounds = form.bounds_of(lobe);
      Colour colour = colour_at(lobe, x, at.peaks());
      if (!is_beyond(lobe, bounds, colour)) continue;
      for (const ColourMember member : lobe.colours.members())
        colour.*member = std::clamp(colour.*member, bounds.lower.*member, bounds.upper.*member);
      set_coefficients(lobe, colour, at.peaks(), x.data());
    }
  }
  return moved;
}

Coordinates::Coordinates(const Form& form, int channels) : form_(form), channels_(channels) {}

bool Coordinates::goes_by_colour(std::size_t first) const {
  return std::any_of(by_colour_.begin(), by_colour_.end(),
                     [&](const ByColour& one) { return one.first == first; });
}

bool Coordinates::follow(std::span<const double> parameters, double near) {
  const BasisAt at(form_, parameters.first(form_.shapes.size()), false);
  const std::size_t before = by_colour_.size();
  for (std::size_t i = 0; i < form_.lobes.size(); ++i) {
    const FormLobe& lobe = form_.lobes[i];
    if (is_diffuse(lobe.colours.columns))
      continue;  // it has one coefficient, with all bounds that there are
    const ColourBounds bounds = form_.bounds_of(lobe);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
      const std::size_t first = form_.first_of(lobe, c);
      const Colour colour =
          colour_at(lobe, parameters.subspan(first, lobe.coefficient_count), at.peaks());
      if ((is_near(lobe, bounds, colour, near) || is_beyond(lobe, bounds, colour)) &&
          !goes_by_colour(first))
        by_colour_.push_back({i, first});
    }
  }
  return by_colour_.size() > before;
}

std::vector<double> Coordinates::from_parameters(std::span<const double> parameters) const {
  std::vector<double> y(parameters.begin(), parameters.end());
  if (plain()) return y;
  const BasisAt at(form_, parameters.first(form_.shapes.size()), false);
  for (const ByColour& one : by_colour_) {
    const FormLobe& lobe = form_.lobes[one.lobe];
    const ColourBounds bounds = form_.bounds_of(lobe);
    const Colour colour =
        colour_at(lobe, parameters.subspan(one.first, lobe.coefficient_count), at.peaks());
    std::size_t k = one.first;
    for (const ColourMember member : lobe.colours.members()) {
      // What is a bound but for rounding is that bound.
      const double upper = bounds.upper.*member, value = std::min(colour.*member, upper);
      y[k++] = value > upper * (1 - kRounding) ? upper : value;
    }
  }
  return y;
}

std::vector<double> Coordinates::to_parameters(std::span<const double> coordinates) const {
  std::vector<double> x(coordinates.begin(), coordinates.end());
  if (plain()) return x;
  const BasisAt at(form_, coordinates.first(form_.shapes.size()), false);
  for (const ByColour& one : by_colour_) {
    const FormLobe& lobe = form_.lobes[one.lobe];
    Colour colour;
    std::size_t k = one.first;
    for (const ColourMember member : lobe.colours.members()) colour.*member = coordinates[k++];
    set_coefficients(lobe, colour, at.peaks(), &x[one.first]);
  }
  return x;
}

Eigen::MatrixXd Coordinates::slopes(std::span<const double> coordinates) const {
  const auto n = static_cast<Eigen::Index>(coordinates.size());
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(n, n);
  if (plain()) return T;
  const BasisAt at(form_, coordinates.first(form_.shapes.size()), true);
  const std::vector<double> x = to_parameters(coordinates);
  for (const ByColour& one : by_colour_) {
    const FormLobe& lobe = form_.lobes[one.lobe];
    const auto members = lobe.colours.members();
    Colour colour;
    for (std::size_t j = 0; j < members.size(); ++j)
      colour.*members[j] = coordinates[one.first + j];
    for (std::size_t k = 0; k < lobe.coefficient_count; ++k) {
      const std::size_t column = lobe.first_column + k;
      const auto row = static_cast<Eigen::Index>(one.first + k);
      for (std::size_t j = 0; j < members.size(); ++j) {
        T(row, static_cast<Eigen::Index>(one.first + j)) =
            slopes_of(lobe.colours.columns, colour, members[j])[k] * at.peaks()[column];
      }
      for (std::size_t p = 0; p < form_.shapes.size(); ++p)
        T(row, static_cast<Eigen::Index>(p)) = x[one.first + k] * at.peak_slope(p, column);
    }
  }
  return T;
}

Bounds Coordinates::bounds() const {
  Bounds all;
  for (const ShapeParameter& shape : form_.shapes) {
    all.lower.push_back(shape.scale.to_search(shape.lower));
    all.upper.push_back(shape.scale.to_search(shape.upper));
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    for (const FormLobe& lobe : form_.lobes) {
      const ColourBounds bounds = form_.bounds_of(lobe);
      const bool by_colour = goes_by_colour(form_.first_of(lobe, c));
      for (const ColourMember member : lobe.colours.members()) {
        const bool own = by_colour || is_diffuse(lobe.colours.columns);
        all.lower.push_back(own ? bounds.lower.*member : 0);
        all.upper.push_back(own ? bounds.upper.*member : kInfinity);
      }
    }
  }
  return all;
}

std::vector<std::string> Coordinates::fields(std::size_t coordinate) const {
  if (coordinate < form_.shapes.size()) return {form_.shapes[coordinate].field};
  const std::size_t own = (coordinate - form_.shapes.size()) % form_.coefficients;
  for (const FormLobe& lobe : form_.lobes) {
    const std::size_t at = own - lobe.first_coefficient;
    if (own < lobe.first_coefficient || at >= lobe.coefficient_count) continue;
    const auto members = lobe.colours.members();
    const auto field = [&](ColourMember member) {
      return field_of(lobe.prefix, lobe.colours.parameter(member));
    };
    if (members.size() == 1 || at == 2 || goes_by_colour(coordinate - at))
      return {field(members[at])};
    // Either coefficient of a reflectance moves both numbers.
    return {field(members[1]), field(members[0])};
  }
  return {};
}

}  // namespace gonio::fit
