#include "chart/sampling_cases.h"

namespace gonio::chart {
namespace {

template <class T>
using Function = std::array<T, 3> (*)(const Vector<T>&, const Vector<T>&);

// One sample after the other: a direction, its density, and f cos(theta_o) / pdf.
template <class Strategy, const Strategy& kStrategy, Function<float> kPrinted>
void scalar(const float* wi, const float* xi, std::size_t n, float* wo, float* pdf,
            float* weights) {
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<float> in{wi[3 * i], wi[3 * i + 1], wi[3 * i + 2]};
    const Vector<float> out = kStrategy.draw(in, {xi[3 * i], xi[3 * i + 1], xi[3 * i + 2]});
    const bool lost = !(out[2] > 0);
    pdf[i] = lost ? 0 : kStrategy.pdf(in, out);
    const Rgb<float> f = lost ? Rgb<float>{} : kPrinted(in, out);
    for (std::size_t c = 0; c < 3; ++c) {
      wo[3 * i + c] = out[c];
      weights[3 * i + c] = lost ? 0 : f[c] * out[2] / pdf[i];
    }
  }
}

template <class Strategy>
SamplingCase drawn_by(const MaterialSpec& spec, const Strategy& strategy, std::string name) {
  return {std::move(name), spec,
          [strategy](const Vector64& wi, const Vector64& xi) { return strategy.draw(wi, xi); },
          [strategy](const Vector64& wi, const Vector64& wo) { return strategy.pdf(wi, wo); }};
}

// The strategies with the parameters of model_cases().
template <class T>
struct Fixed {
  static constexpr Cosine<T> kCosine{};
  static constexpr HalfCosine<T, ByHalfVector<T, PowerNormals<T>>> kAshikhminShirley{
      {{T(100), T(10)}}};
  static constexpr ByHalfVector<T, Beckmann<T>> kBeckmann{{T(0.3), T(0.3)}};
  static constexpr ByHalfVector<T, GgxNormals<T>> kGgx{{T(0.3), T(0.2)}};
  static constexpr HalfCosine<T, AboutMirror<T>> kPhong{{T(100)}};
  static constexpr HalfCosine<T, ByHalfVector<T, PowerNormals<T>>> kBlinn{{{T(100), T(100)}}};
  static constexpr ByHalfVector<T, PowerNormals<T>> kPower{{T(101), T(101)}};
  static constexpr ByHalfVector<T, Beckmann<T>> kWard{{T(0.3), T(0.2)}};
};

template <class Strategy32, const Strategy32& kStrategy, Function<float> kPrinted, class Strategy64>
SamplingCase timed(const std::string& name, const Strategy64& strategy) {
  const auto cases = model_cases<float>();
  const auto found = std::find_if(cases.begin(), cases.end(),
                                  [&](const auto& model) { return model.name == name; });
  SamplingCase made = drawn_by(found->spec, strategy, name);
  made.scalar = &scalar<Strategy32, kStrategy, kPrinted>;
  return made;
}

#define GONIO_TIMED(name, strategy, printed) \
  timed<decltype(F::strategy), F::strategy, &Printed<float>::printed>(name, D::strategy)

}  // namespace

std::vector<SamplingCase> timed_cases() {
  using F = Fixed<float>;
  using D = Fixed<double>;
  return {GONIO_TIMED("lambertian", kCosine, lambertian),
          GONIO_TIMED("ashikhmin_shirley", kAshikhminShirley, ashikhmin_shirley),
          GONIO_TIMED("cook_torrance", kBeckmann, cook_torrance),
          GONIO_TIMED("ggx", kGgx, ggx),
          GONIO_TIMED("phong", kPhong, phong),
          GONIO_TIMED("blinn_phong", kBlinn, blinn_phong),
          GONIO_TIMED("phong_mix", kPhong, phong_mix),
          GONIO_TIMED("cook_torrance s", kPower, cook_torrance_power),
          GONIO_TIMED("oren_nayar full", kCosine, template oren_nayar<true>),
          GONIO_TIMED("oren_nayar short", kCosine, template oren_nayar<false>),
          GONIO_TIMED("ward", kWard, ward)};
}

#undef GONIO_TIMED

std::vector<BoundedCase> bounded_cases() {
  using Numbers = std::vector<double>;
  const auto alone = [](LobeSpec lobe) {
    return MaterialSpec{.model = std::move(lobe), .diffuse = {}, .specular = {}};
  };
  const auto shirley = [&](double rd, double rs) {
    return alone(
        {"ashikhmin_shirley",
         {{"rd", Numbers{rd}}, {"rs", Numbers{rs}}, {"nu", Numbers{10}}, {"nv", Numbers{100}}}});
  };
  const ByHalfVector<double, PowerNormals<double>> paper{{10, 100}};
  const HalfCosine<double, ByHalfVector<double, PowerNormals<double>>> half_cosine{paper};
  const auto ggx = drawn_by(alone({"ggx",
                                   {{"alpha_x", Numbers{0.3}},
                                    {"alpha_y", Numbers{0.3}},
                                    {"fresnel", std::string("none")}}}),
                            ByHalfVector<double, GgxNormals<double>>{{0.3, 0.3}}, "ggx .3");
  const auto beckmann =
      drawn_by(alone({"cook_torrance", {{"m", Numbers{0.3}}, {"fresnel", std::string("none")}}}),
               ByHalfVector<double, Beckmann<double>>{{0.3, 0.3}}, "cook_torrance .3");
  const auto metal = drawn_by(shirley(0, 1), paper, "ashikhmin_shirley 10 100");
  const auto glossy = drawn_by(shirley(0.5, 0.05), half_cosine, "the same, rd .5, rs .05");
  return {{ggx, 75, 0, 0.055},   {beckmann, 75, 0, 0.060}, {metal, 75, 0, 0.1},
          {metal, 75, 90, 0.1},  {glossy, 10, 0, 0.15},    {glossy, 75, 0, 0.15},
          {glossy, 75, 90, 0.15}};
}

}  // namespace gonio::chart
