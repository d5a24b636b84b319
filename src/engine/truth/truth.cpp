#include "engine/truth/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/kernels/constants.h"
#include "engine/kernels/measured_lookup.h"
#include "engine/kernels/prepare.h"
#include "engine/material/material_impl.h"
#include "models/all.h"
#include "numeric/extended.h"
#include "parts/geometry.h"

namespace gonio {
namespace {

using Pair = Geometry<Extended>;
using Results = std::span<long double>;

// An analytic lobe: the kernels' way through a model's steps, for one pair.
template <class Kind>
void add_lobe(const void* constants, const Pair& pair, Results f) {
  const auto& k = *static_cast<const Constants<Kind, LongDouble>*>(constants);
  Pair seen = pair;
  if constexpr (has_tangents<Kind>()) {
    if (k.tangents.turned) seen.turn(k.tangents.rotation);
  }
  const auto stage = Kind::template stage<Extended>(k.shape, seen);
  const auto refined = Kind::template refine<Extended>(k.shape, stage);
  const auto terms = Kind::template terms<Extended>(k.shape, stage, refined);
  for (std::size_t c = 0; c < f.size(); ++c) {
    const LongDouble value = Kind::template value<Extended>(terms, k.wide[c], k.wide[c]);
    f[c] += min(Extended::largest(), value).v;
  }
}

using AddLobe = void (*)(const void*, const Pair&, Results);

template <class... Kinds>
AddLobe add_function(std::size_t kind, TypeList<Kinds...>) {
  static constexpr AddLobe kFunctions[] = {&add_lobe<Kinds>...};
  return kFunctions[kind];
}

// Whether a position is so near to a cell's edge that float32's rounding decides between cells.
bool at_an_edge(const TablePosition<Extended>& at) {
  constexpr long double kNear = 1e-3L;
  const auto near = [](LongDouble x) { return std::abs(x.v - std::round(x.v)) < kNear; };
  return near(at.h) || near(at.d) || near(at.p);
}

// Next to h = n or wi = wo, and not at it, the azimuth that a table is read at is a matter of
// rounding.
bool has_no_azimuth(const Pair& pair) {
  constexpr long double kNear = 1e-8L;  // of squared sines
  const Vec3<LongDouble>&h = pair.half.h, d = pair.wi - pair.wo;
  const long double across = h.x.v * h.x.v + h.y.v * h.y.v, apart = dot(d, d).v;
  return (across > 0 && across < kNear * h.z.v * h.z.v) ||
         (apart > 0 && apart < kNear * dot(h, h).v);
}

template <int kCorners>
void add_cells(const float* table, const Pair& pair, Results f, Results scale) {
  const TablePosition<Extended> at = locate(pair);
  Corner<Extended> corner[kCorners];
  find_corners(at, corner);
  const bool unsure = (kCorners == 1 && at_an_edge(at)) || has_no_azimuth(pair);
  for (std::size_t c = 0; c < f.size(); ++c) {
    long double total = 0, sum = 0, largest = 0;
    for (const auto& k : corner) {
      const auto channel = static_cast<int>(c);
      const LongDouble value = fetch<Extended>(table, k.index, channel);
      if (!(value.v > -1)) continue;  // NaN: not measured
      total += k.weight.v;
      sum += k.weight.v * value.v;
      largest = std::max(largest, value.v);
    }
    f[c] += total > 0 ? sum / total : 0;
    if (!scale.empty()) scale[c] = unsure ? std::numeric_limits<long double>::quiet_NaN() : largest;
  }
}

}  // namespace

struct Truth::Part {
  AddLobe add = nullptr;  // null: a table
  std::shared_ptr<const void> constants;
  bool linear = false;
};

namespace {

// A lobe with one of its numbers, in all channels, times `factor`.
ParameterValues<double> scaled(const ParameterValues<double>& values, std::string_view name,
                               double factor) {
  ParameterValues<double> changed = values;
  std::vector<double> numbers = values.all().find(name)->second;
  for (double& number : numbers) number *= factor;
  changed.set(name, std::move(numbers));
  return changed;
}

}  // namespace

Truth::Truth(const Material& material) : channels_(material.channels()) {
  for (const MaterialPart& part : material.impl().parts) {
    if (part.lobe == nullptr) {
      const bool linear = part.source == MaterialPart::Source::measured_linear;
      add(std::make_shared<const Part>(Part{nullptr, part.constants, linear}));
      continue;
    }
    PreparedLobe prepared =
        prepare_extended(*part.lobe->model, part.lobe->kind, part.lobe->values, channels_);
    add(std::make_shared<const Part>(
        Part{add_function(prepared.kernel, AllKinds{}), std::move(prepared.constants), false}));
  }
}

std::vector<Truth> Truth::of_roundings(const Material& material, double relative) {
  std::vector<Truth> all;
  const auto& parts = material.impl().parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].lobe == nullptr) continue;
    const CheckedLobe& lobe = *parts[i].lobe;
    for (const std::string_view name : lobe.model->crossing) {
      for (const double factor : {1 - relative, 1 + relative}) {
        PreparedLobe moved = prepare_extended(
            *lobe.model, lobe.kind, scaled(lobe.values, name, factor), material.channels());
        Truth truth(material);
        truth.parts_[i] = std::make_shared<const Part>(
            Part{add_function(moved.kernel, AllKinds{}), std::move(moved.constants), false});
        all.push_back(std::move(truth));
      }
    }
  }
  return all;
}

void Truth::evaluate(const Direction& wi, const Direction& wo, std::span<long double> f,
                     std::span<long double> scale) const {
  std::ranges::fill(f, 0.0L);
  std::ranges::fill(scale, 0.0L);
  const Vec3<LongDouble> i{wi[0], wi[1], wi[2]}, o{wo[0], wo[1], wo[2]};
  const Pair pair(i, o, i, o);
  if (!pair.valid) return;
  for (const auto& part : parts_) {
    if (part->add != nullptr) {
      part->add(part->constants.get(), pair, f);
      continue;
    }
    const float* table = static_cast<const MeasuredConstants*>(part->constants.get())->table;
    return part->linear ? add_cells<8>(table, pair, f, scale) : add_cells<1>(table, pair, f, scale);
  }
  if (!scale.empty()) std::ranges::copy(f, scale.begin());
}

}  // namespace gonio
