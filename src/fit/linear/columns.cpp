#include "fit/linear/columns.h"

namespace gonio::fit {
namespace {

bool is_quadratic(const FormLobe& lobe) {
  return lobe.colours.columns == Columns::quadratic_diffuse;
}

// Adds what a lobe's reflectance changes by with the shape whose derivatives begin at that column.
void add_slope(const FormLobe& lobe, const Basis& basis, std::size_t first,
               std::span<const double> coefficients, Eigen::ArrayXd& sum) {
  for (std::size_t k = 0; k < lobe.column_count; ++k) {
    const double x = coefficients[lobe.first_coefficient + (is_quadratic(lobe) ? 0 : k)];
    const std::size_t at = (first + lobe.first_column + k) * basis.stride;
    sum += (is_quadratic(lobe) && k == 1 ? x * x : x) *
           Eigen::Map<const Eigen::ArrayXd>(&basis.derivatives[at], sum.size());
  }
}

}  // namespace

void sum_columns(const Form& form, const Basis& basis, std::size_t count,
                 std::span<const double> coefficients, Eigen::ArrayXd& f) {
  const auto n = static_cast<Eigen::Index>(count);
  f.setZero(n);
  for (const FormLobe& lobe : form.lobes) {
    for (std::size_t k = 0; k < lobe.column_count; ++k) {
      const double x = coefficients[lobe.first_coefficient + (is_quadratic(lobe) ? 0 : k)];
      const Eigen::Map<const Eigen::ArrayXd> column(
          &basis.values[(lobe.first_column + k) * basis.stride], n);
      f += (is_quadratic(lobe) && k == 1 ? x * x : x) * column;
    }
  }
}

void derive_columns(const Form& form, const Basis& basis, std::size_t count,
                    std::span<const double> coefficients, const Eigen::ArrayXd& slope,
                    Eigen::MatrixXd& jacobian) {
  const auto n = static_cast<Eigen::Index>(count);
  const auto shapes = static_cast<Eigen::Index>(form.shapes.size());
  jacobian.resize(n, shapes + static_cast<Eigen::Index>(form.coefficients));
  const auto column = [&](std::size_t k) {
    return Eigen::Map<const Eigen::ArrayXd>(&basis.values[k * basis.stride], n);
  };
  for (Eigen::Index p = 0; p < shapes; ++p) {
    const auto shape = static_cast<std::size_t>(p);
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(n);
    for (std::size_t i = 0; i < form.lobes.size(); ++i) {
      if (depends(form, i, form.shapes[shape]))
        add_slope(form.lobes[i], basis, shape * form.columns, coefficients, sum);
    }
    jacobian.col(p) = (sum * slope).matrix();
  }
  for (const FormLobe& lobe : form.lobes) {
    for (std::size_t k = 0; k < lobe.coefficient_count; ++k) {
      const std::size_t j = lobe.first_coefficient + k;
      auto target = jacobian.col(shapes + static_cast<Eigen::Index>(j)).array();
      target = column(lobe.first_column + k) * slope;
      if (is_quadratic(lobe)) target += 2 * coefficients[j] * column(lobe.first_column + 1) * slope;
    }
  }
}

}  // namespace gonio::fit
