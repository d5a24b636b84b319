// Formulas as publications print them, and the right ones: times of scalar loops in float64, and
// errors.
#include <algorithm>
#include <array>
#include <cmath>

#include "assess/random_directions.h"
#include "chart/chart.h"
#include "chart/common.h"
#include "chart/printed.h"
#include "timing/pairs.h"

namespace gonio::chart {
namespace {

template <class T>
using V = Rgb<T>;

// Formulas of one channel. `kPrinted`: as printed.
template <class T>
struct Forms : assess::Naive<T> {
  using Form = assess::Naive<T>;
  using Form::dot;
  using Form::half;
  using Form::kPi;

  // Nielsen et al. 2014, eq. 2. The compiler does not know the exponent, which belongs to a
  // material.
  template <bool kPrinted>
  static T blinn_norm(const V<T>& wi, const V<T>& wo, T s) {
    const V<T> h = half(wi, wo);
    if constexpr (!kPrinted) return Form::blinn_phong(h, s);
    return (s + 8) / (8 * kPi) * std::pow(h[2], s);
  }
  template <bool kPrinted>
  static T phong_clamp(const V<T>& wi, const V<T>& wo, T s) {
    if constexpr (!kPrinted) return Form::phong(wi, wo, s);
    const T mirror = wi[2] * wo[2] - wi[0] * wo[0] - wi[1] * wo[1];
    return (s + 2) / (2 * kPi) * std::pow(mirror, s);
  }
  static T fresnel(T c, T g_sign, T denominator_sign) {
    const T g = std::sqrt(T(2.25) + g_sign + c * c);
    const T a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + denominator_sign);
    return a * a * (1 + b * b) / 2;
  }
  template <bool kPrinted>
  static T fresnel_g(const V<T>& wi, const V<T>& wo, T) {
    return fresnel(dot(half(wi, wo), wi), kPrinted ? 1 : -1, 1);
  }
  template <bool kPrinted>
  static T fresnel_denominator(const V<T>& wi, const V<T>& wo, T) {
    return fresnel(dot(half(wi, wo), wi), -1, kPrinted ? -1 : 1);
  }
  template <bool kPrinted>
  static T fresnel_angle(const V<T>& wi, const V<T>& wo, T) {
    return fresnel(kPrinted ? wi[2] : dot(half(wi, wo), wi), -1, 1);
  }
  template <bool kPrinted>
  static T beckmann_norm(const V<T>& wi, const V<T>& wo, T m) {
    const T d = Form::beckmann(half(wi, wo), m);
    return kPrinted ? d * kPi / 4 : d;
  }
  template <bool kPrinted>
  static T microfacet_divisor(const V<T>& wi, const V<T>& wo, T m) {
    const V<T> h = half(wi, wo);
    const T f = Form::cook_torrance(wi, wo, h, dot(h, wi), Form::beckmann(h, m));
    return kPrinted ? 4 * wi[2] * f : f;
  }
  template <bool kPrinted>
  static T half_length(const V<T>& wi, const V<T>& wo, T s) {
    if constexpr (!kPrinted) return Form::blinn_phong(half(wi, wo), s);
    return Form::blinn_phong({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]}, s);
  }
};

template <class T>
using Formula = T (*)(const V<T>&, const V<T>&, T);

struct Pair {
  std::string what, source;
  double parameter;
  Formula<double> printed, right;
  Formula<long double> truth;
};

#define GONIO_FORMS(name) \
  &Forms<double>::name<true>, &Forms<double>::name<false>, &Forms<long double>::name<false>

std::vector<Pair> all_pairs() {
  const std::string nielsen = "Nielsen et al. 2014", lecture = "lecture on BRDFs";
  return {
      {"Blinn's norm as (s+8)/(8 pi), s = 1", nielsen, 1, GONIO_FORMS(blinn_norm)},
      {"Blinn's norm as (s+8)/(8 pi), s = 10", nielsen, 10, GONIO_FORMS(blinn_norm)},
      {"Blinn's norm as (s+8)/(8 pi), s = 1000", nielsen, 1000, GONIO_FORMS(blinn_norm)},
      {"Phong's cosine without a clamp, s = 11", nielsen, 11, GONIO_FORMS(phong_clamp)},
      {"Fresnel's g^2 with + 1", lecture, 0, GONIO_FORMS(fresnel_g)},
      {"Fresnel's denominator with - 1", lecture, 0, GONIO_FORMS(fresnel_denominator)},
      {"Fresnel's cosine at the normal", lecture, 0, GONIO_FORMS(fresnel_angle)},
      {"Beckmann over 4 m^2", lecture, 0.3, GONIO_FORMS(beckmann_norm)},
      {"microfacets over n.v alone", lecture, 0.3, GONIO_FORMS(microfacet_divisor)},
      {"the half-vector not normalised, s = 10", lecture, 10, GONIO_FORMS(half_length)},
  };
}

#undef GONIO_FORMS

// Errors over pairs with both angles up to 80 degrees.
ErrorStatistics errors_of(const Pair& forms, Formula<double> form, const Options& options) {
  assess::Random random(options.seed);
  const double least = std::cos(80 * assess::kDegree);
  assess::ErrorList errors;
  for (std::size_t i = 0; i < 10 * options.pairs;) {
    const auto wi = random.hemisphere(), wo = random.hemisphere();
    if (std::min(wi[2], wo[2]) < least) continue;
    ++i;
    const double value = form(wi, wo, forms.parameter);
    const long double truth = forms.truth({wi[0], wi[1], wi[2]}, {wo[0], wo[1], wo[2]},
                                          static_cast<long double>(forms.parameter));
    if (!std::isfinite(value) || value < 0) ++errors.improper;
    if (std::isfinite(value) && truth > 1e-12L)
      errors.relative.push_back(static_cast<double>(std::abs(value - truth) / truth));
  }
  return statistics_of(std::move(errors));
}

timing::Runner runner_of(const std::shared_ptr<timing::Pairs>& pairs, Formula<double> form,
                         double parameter) {
  double* out = pairs->reference().values.data;
  const auto run = [pairs, form, parameter, out] {
    const auto at = [&](std::size_t k, std::size_t i) { return double(pairs->component(k)[i]); };
    for (std::size_t i = 0; i < pairs->count(); ++i)
      out[i] = form({at(0, i), at(1, i), at(2, i)}, {at(3, i), at(4, i), at(5, i)}, parameter);
  };
  return {run, static_cast<double>(pairs->count())};
}

}  // namespace

Result<Table> chart_printed(const Options& options) {
  const auto pairs = std::make_shared<timing::Pairs>(timing::kTimedPairs);
  Table table{
      "printed",
      "Formulas as printed and as they are right, as scalar loops in float64",
      {{"what", "", "what is printed"}, {"source", "", "where"}, {"form", "", "printed or right"}},
      {}};
  add_time_columns(table, "ns", "ns", "time of one evaluation of one channel");
  add_error_columns(table);
  std::vector<timing::Runner> runners;
  const std::vector<Pair> all = all_pairs();
  for (const Pair& forms : all) {
    runners.push_back(runner_of(pairs, forms.printed, forms.parameter));
    runners.push_back(runner_of(pairs, forms.right, forms.parameter));
  }
  const auto seconds = timing::race(runners, options.effort, options.stop);
  if (is_over(options)) return was_cancelled();
  for (std::size_t i = 0; i < runners.size(); ++i) {
    const Pair& forms = all[i / 2];
    const bool printed = i % 2 == 0;
    std::vector<Cell> row{forms.what, forms.source, std::string(printed ? "printed" : "right")};
    add_time_cells(row, scaled(seconds[i], 1e9));
    add_error_cells(row, errors_of(forms, printed ? forms.printed : forms.right, options));
    table.rows.push_back(std::move(row));
  }
  add_front(table, "ns", "error_worst", "what");
  show(options, 1);
  return table;
}

}  // namespace gonio::chart
