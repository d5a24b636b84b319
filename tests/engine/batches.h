// Materials and direction pairs for the tests of batches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "gonio/engine/evaluate.h"
#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"

namespace gonio::testing {

struct NamedMaterial {
  std::string name;
  Material material;
};

// One of every kind: each model, few and many channels, a sum, a table both ways.
inline std::vector<NamedMaterial> all_kinds_of_material() {
  using Colour = std::vector<double>;
  Colour spectrum;
  for (int i = 0; i < kMaxChannels; ++i) spectrum.push_back(0.2 + 0.01 * i);
  const LobeSpec base{"lambertian", {{"rd", Colour{0.1, 0.2, 0.3}}}};
  const LobeSpec phong{
      "ashikhmin_shirley",
      {{"nu", Colour{1000}}, {"nv", Colour{10}}, {"rs", Colour{0.4}}, {"rd", Colour{0.2}}}};
  const LobeSpec metal{"cook_torrance", {{"m", Colour{0.2}}, {"f0", Colour{0.95, 0.64, 0.54}}}};
  const LobeSpec glass{"ggx",
                       {{"alpha_x", Colour{0.1}}, {"alpha_y", Colour{0.3}}, {"eta", spectrum}}};
  const LobeSpec coat{"ggx",
                      {{"alpha_x", Colour{0.1}}, {"alpha_y", Colour{0.1}}, {"k", Colour{2}}}};
  const LobeSpec brushed{"ward", {{"alpha_x", Colour{0.1}}, {"alpha_y", Colour{0.4}}}};
  std::vector<NamedMaterial> all;
  const auto add = [&all](std::string name, const MaterialSpec& spec) {
    auto material = Material::create(spec);
    if (!material) throw std::invalid_argument(material.error().message);
    all.push_back({std::move(name), *material});
  };
  add("lambertian", {base, {}, {}});
  add("ashikhmin_shirley", {phong, {}, {}});
  add("cook_torrance", {metal, {}, {}});
  add("ggx in 64 channels", {glass, {}, {}});
  add("sum", {{}, base, {phong, metal, coat, phong}});
  add("ashikhmin_shirley, turned", {phong, {}, {}, 30});
  add("sum, turned", {{}, base, {brushed, metal}, -77.7});
  const auto table = MeasuredTable::from_values(tabulate(glossy_example));
  all.push_back({"measured", Material::from_table(*table, Interpolation::linear)});
  all.push_back({"measured, nearest", Material::from_table(*table, Interpolation::nearest)});
  return all;
}

// Interleaved pairs over the hemisphere, some of them near the mirror direction.
template <class In>
struct Pairs {
  std::vector<In> wi, wo;
  [[nodiscard]] std::size_t size() const { return wi.size() / 3; }
};

template <class In>
Pairs<In> random_pairs(std::size_t count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Pairs<In> pairs;
  const auto add = [](std::vector<In>& to, double theta, double phi) {
    for (const double c :
         {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}) {
      to.push_back(static_cast<In>(c));
    }
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double theta = std::acos(unit(random)), phi = 6.28 * unit(random);
    add(pairs.wi, theta, phi);
    if (i % 2 == 0) {
      add(pairs.wo, std::min(1.57, theta + 0.1 * (unit(random) - 0.5)), phi + 3.14159);
    } else {
      add(pairs.wo, std::acos(unit(random)), 6.28 * unit(random));
    }
  }
  return pairs;
}

// The three kinds of evaluation that there are.
template <class I, class O>
struct InOut {
  using In = I;
  using Out = O;
};

template <class In, class Out>
Batch<In, Out> batch_of(const Pairs<In>& pairs, std::size_t first, std::size_t count, Out* values,
                        int channels, std::uint8_t* flags) {
  return {Directions<In>::interleaved(pairs.wi.data() + 3 * first),
          Directions<In>::interleaved(pairs.wo.data() + 3 * first), count,
          Values<Out>::interleaved(values, channels), flags};
}

// Bit for bit, so that even a NaN or the sign of a 0 would show.
template <class T>
bool same_bits(const T* a, const T* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(T)) == 0;
}

}  // namespace gonio::testing
