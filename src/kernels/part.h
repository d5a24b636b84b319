// The one interface of whatever evaluates: an analytic lobe, a measured table, a solved medium.
//
// A material is a sum of parts. A part is immutable data and a table of operations, PartKind.
// Nothing else in the engine, and nothing above it, asks what a part is.
//
// An analytic model is one header, src/models/NAME.h, and a line of models/list.h. It has
//   kDescription          its table (gonio/models/description.h)
//   Kinds                 a type per combination of its words, each with the steps below
// and each kind's steps are templates over the number system N (numeric/number.h): packets of
// float32 and float64, dual numbers, long double. They have no branches: select(), min() and max().
//   shape(values)         once per material: the numbers that all channels share, in S = double,
//                         Dual<double> or LongDouble
//   channel(values, c)    once per channel and material
//   stage(shape, geometry)          of a pair: what the later steps read; cheap arithmetic
//   refine(shape, stage)            what needs float64 in `fast` too: exponents, differences
//   terms(shape, stage, refined)    what all channels share, in N::Real
//   eval(terms, wide, real)         f of a channel, 1/sr, from its constants in float64 and N::Real
// A kind that draws samples has `Drawn` (its model) and
//   aim(shape, geometry)            what the density needs of a pair beside the steps above
//   pdf(shape, stage, refined, aim) per steradian of wo; 0 below the horizon
//   Drawn::sample(shape, wi, xi)    wo for numbers xi in [0, 1)^3; below the horizon if it is lost
// Steps get valid, normalised pairs above the horizon, and lanes with anything in them, whose
// results are thrown away: they may not trap, read memory by index, or keep state.
//
// A measured format is one folder, src/measured/NAME, and a line of models/list.h. It fills a
// PartModel by hand, with kernels compiled per instruction set (see measured/merl).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/models/description.h"
#include "kernels/sampling_kernel.h"
#include "schema/checked_lobe.h"

namespace gonio {

class MeasuredTable;
struct Part;
struct Extended;  // numeric/extended.h: long double
template <class N>
class Geometry;  // parts/geometry.h

// Data that kernels read, and how much memory it holds.
struct PartData {
  std::shared_ptr<const void> data;
  std::size_t bytes = 0;
};

// f of a pair in long double, added to `f`; what error bounds are relative to, added to `scale`
// unless that is empty: f, or the largest of the cells that are interpolated, or NaN where rounding
// decides which cells these are.
struct PartTruth {
  std::shared_ptr<const void> data;
  void (*add)(const void* data, const Geometry<Extended>& pair, std::span<long double> f,
              std::span<long double> scale) = nullptr;
};

// Writes the luminance of f, without a cosine, of each pair; 0 where it is not known.
using PartDirection = std::array<double, 3>;
using PartLuminance =
    std::function<void(std::span<const PartDirection> wi, std::span<const PartDirection> wo,
                       std::span<double> luminance)>;

// The operations of a kind of part.
struct PartKind {
  std::array<const PartKernels*, 3> by_isa{};  // eval, pdf and sample of whole runs of pairs

  // From checked parameters: the data of the part, and that of its derivative by the parameter
  // `by`. Null for what is made of measurements.
  PartData (*prepare)(const CheckedLobe& lobe, int channels) = nullptr;
  PartData (*prepare_derivative)(const CheckedLobe& lobe, int channels,
                                 std::string_view by) = nullptr;

  PartTruth (*truth)(const Part& part) = nullptr;

  // What draws and densities read; null: the part's own data.
  PartData (*prepare_sampling)(const Part& part, const PartLuminance& luminance) = nullptr;

  // Whether values may be unknown in places (flag::outside_data).
  bool has_gaps = false;
  // The cells that the part was measured in; null for what was not.
  std::shared_ptr<const MeasuredTable> (*table)(const Part& part) = nullptr;

  [[nodiscard]] const PartKernels& kernels(Isa isa) const {
    return *by_isa[static_cast<std::size_t>(isa)];
  }
  [[nodiscard]] bool draws() const { return by_isa[0]->sampling.draw64 != nullptr; }
};

struct Part {
  const PartKind* kind = nullptr;
  PartData made;
  std::shared_ptr<const CheckedLobe> lobe;  // model, words and numbers that it was made of
  int channels = 1;
};

// What the registry knows of a model or a format.
struct PartModel {
  ModelDescription description;
  std::span<const PartKind> kinds;        // by combination of its words
  std::span<const PartKind> derivatives;  // the same; empty for what has none
  // Of a format: reads a file as the lobe's words say. Errors are those of its reader.
  Result<Part> (*read)(const std::filesystem::path& file, const CheckedLobe& lobe) = nullptr;
};

}  // namespace gonio
