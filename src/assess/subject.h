// A material as the assessment sees it: a set of functions, one of which a test can replace by a
// faulty one. Thread safety: as its functions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "assess/naive_material.h"
#include "engine/truth/truth.h"
#include "gonio/engine/material.h"
#include "gonio/engine/sampler.h"
#include "gonio/measured/table.h"

namespace gonio::assess {

// Directions as they are given, x, y and z. Those for Precision::fast are float32 numbers.
struct Pair {
  std::array<double, 3> wi, wo;
};

// Of the directions drawn for one wi: interleaved xyz; weights channel by channel.
struct Drawn {
  std::vector<double> wo, pdf, weights;
  std::vector<std::uint8_t> flags;
  std::uint64_t lost = 0;
};

// A change of parameters that is small, but large enough for long double.
inline constexpr double kStep = 0x1p-40;

struct Subject {
  int channels = 1;
  ErrorBound fast, reference;

  // f of every pair, all channels of the first, then of the second.
  std::function<std::vector<double>(std::span<const Pair>, Precision)> evaluate;
  // f and pdf, in float64.
  struct Densities {
    std::vector<double> f, pdf;
  };
  std::function<Densities(std::span<const Pair>)> densities;
  std::function<Drawn(const std::array<double, 3>& wi, std::size_t count,
                      const NumberSource& numbers, Precision)>
      draw;

  double tangents = 0;  // the azimuth of u, in radians

  // Refractive indices below 1 of its dielectrics, which reflect all light beyond a critical angle.
  std::vector<double> rarer;

  std::shared_ptr<const MeasuredTable> table;  // of a measured material, else null

  Truth truth;
  std::vector<Truth> roundings;  // see Truth::of_roundings; by kStep
  std::optional<NaiveMaterial<float>> naive32;
  std::optional<NaiveMaterial<double>> naive64;

  [[nodiscard]] const ErrorBound& bound(Precision precision) const {
    return precision == Precision::fast ? fast : reference;
  }
};

Subject subject_of(const Sampler& sampler, Isa isa);

}  // namespace gonio::assess
