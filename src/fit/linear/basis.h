// The columns of a form, and their derivatives by the shape parameters, at a run of pairs.
//
// Everything is evaluated by the engine's reference kernels from the models' one formula; nothing
// here knows a model.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/material/derivative.h"
#include "fit/data/data.h"
#include "fit/form.h"
#include "gonio/engine/material.h"

namespace gonio::fit {

inline constexpr std::size_t kTile = 1024;  // pairs that are worked on at a time

// Column k of pair i is at values[k * stride + i]; its derivative by shape p (search scale) at
// derivatives[(p * columns + k) * stride + i].
struct Basis {
  std::size_t stride = 0;
  std::vector<double> values, derivatives;
};

class BasisAt {
 public:
  // The columns for the given shapes, in search scale. Shapes out of the models' bounds are
  // clamped.
  BasisAt(const Form& form, std::span<const double> shapes, bool derivatives);

  void evaluate(const Data& data, std::size_t first, std::size_t count, Basis& to) const;

  // The value by which each column is divided: its lobe's first column where wi = wo = n.
  [[nodiscard]] const std::vector<double>& peaks() const { return peaks_; }
  // d log(peak) / du; only with derivatives.
  [[nodiscard]] double peak_slope(std::size_t shape, std::size_t column) const {
    return peak_slopes_[shape * form_.columns + column];
  }

 private:
  struct ByShape {
    std::size_t shape;
    double slope;  // dp/du
    std::vector<MaterialDerivative> by;
  };
  struct Lobe {
    Material material;
    std::vector<ByShape> shapes;
  };
  void evaluate_lobe(std::size_t lobe, const Batch<float, double>& batch, Basis& to) const;
  void normalise(std::size_t lobe, std::size_t count, Basis& to) const;
  void measure_peaks();

  const Form& form_;
  std::vector<Lobe> lobes_;
  std::vector<double> peaks_;        // a column
  std::vector<double> peak_slopes_;  // d log(peak) / du, [shape][column]
  std::size_t shape_count_ = 0;
};

// The parameters (shapes in search scale, then each channel's coefficients) as a material.
// `exact`: colours as they follow; else what rounding takes beyond a model's table is moved back.
MaterialSpec to_material(const Form& form, std::span<const double> parameters, int channels,
                         bool exact = false);

}  // namespace gonio::fit
