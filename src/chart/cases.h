// The cases of charts and benchmarks: a material of each model, and its printed form with the same
// parameters. Thread safety: functions without state.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "chart/printed.h"
#include "gonio/engine/material.h"
#include "timing/pairs.h"

namespace gonio::chart {

template <class T>
using PrintedForm = Rgb<T> (*)(const Rgb<T>& wi, const Rgb<T>& wo);

template <class T>
struct ModelCase {
  std::string name;
  MaterialSpec spec;
  PrintedForm<T> printed;
};

// A material of one model.
inline MaterialSpec alone(LobeSpec lobe) {
  return {.model = std::move(lobe), .diffuse = {}, .specular = {}};
}

template <class T>
std::vector<ModelCase<T>> model_cases() {
  using Numbers = std::vector<double>;
  const Numbers metal{0.9, 0.8, 0.7};
  return {
      {"lambertian", alone({"lambertian", {{"rd", Numbers{0.1, 0.2, 0.3}}}}),
       &Printed<T>::lambertian},
      {"ashikhmin_shirley",
       alone({"ashikhmin_shirley",
              {{"rd", Numbers{0.1, 0.2, 0.3}},
               {"rs", Numbers{0.5, 0.4, 0.3}},
               {"nu", Numbers{100}},
               {"nv", Numbers{10}}}}),
       &Printed<T>::ashikhmin_shirley},
      {"cook_torrance", alone({"cook_torrance", {{"m", Numbers{0.3}}, {"f0", metal}}}),
       &Printed<T>::cook_torrance},
      {"ggx", alone({"ggx", {{"alpha_x", Numbers{0.3}}, {"alpha_y", Numbers{0.2}}, {"f0", metal}}}),
       &Printed<T>::ggx},
      {"phong", alone({"phong", {{"s", Numbers{100}}, {"f0", metal}}}), &Printed<T>::phong},
      {"blinn_phong", alone({"blinn_phong", {{"s", Numbers{100}}, {"f0", metal}}}),
       &Printed<T>::blinn_phong},
      {"phong_mix",
       alone({"phong_mix", {{"s", Numbers{100}}, {"mix", Numbers{0.4}}, {"f0", metal}}}),
       &Printed<T>::phong_mix},
      {"cook_torrance s", alone({"cook_torrance", {{"s", Numbers{100}}, {"f0", metal}}}),
       &Printed<T>::cook_torrance_power},
      {"oren_nayar full",
       alone({"oren_nayar", {{"rd", Numbers{0.1, 0.2, 0.3}}, {"sigma", Numbers{0.3}}}}),
       &Printed<T>::template oren_nayar<true>},
      {"oren_nayar short",
       alone({"oren_nayar",
              {{"rd", Numbers{0.1, 0.2, 0.3}}, {"sigma", Numbers{0.3}}, {"form", "short"}}}),
       &Printed<T>::template oren_nayar<false>},
      {"ward",
       alone({"ward",
              {{"rs", Numbers{0.5, 0.4, 0.3}},
               {"alpha_x", Numbers{0.3}},
               {"alpha_y", Numbers{0.2}}}}),
       &Printed<T>::ward},
  };
}

// Evaluates all pairs once a run as printed, one after the other, in T; an item is a pair.
template <class T>
timing::Runner printed_evaluation(const std::shared_ptr<timing::Pairs>& pairs,
                                  PrintedForm<T> printed) {
  T* out = nullptr;
  if constexpr (std::is_same_v<T, float>) {
    out = pairs->fast().values.data;
  } else {
    out = pairs->reference().values.data;
  }
  const auto run = [pairs, printed, out] {
    const auto at = [&](std::size_t k, std::size_t i) { return T(pairs->component(k)[i]); };
    for (std::size_t i = 0; i < pairs->count(); ++i) {
      const Rgb<T> f = printed({at(0, i), at(1, i), at(2, i)}, {at(3, i), at(4, i), at(5, i)});
      std::copy(f.begin(), f.end(), out + 3 * i);
    }
  };
  return {run, static_cast<double>(pairs->count())};
}

}  // namespace gonio::chart
