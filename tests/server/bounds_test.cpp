// Ten million random evaluations and samples, over all models: none is farther from truth than the
// reply itself says. Truth is the templates' in long double, which tests/models holds to the
// 128-bit oracle.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "engine/truth/truth.h"
#include "numeric/direction.h"
#include "server/materials/build_material.h"
#include "server/support/sample_requests.h"
#include "wire/convert.h"

namespace gonio::server::testing {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kRounds = 1;  // a thousand times slower in all: only that it runs
#else
constexpr int kRounds = 9;
#endif
constexpr std::size_t kPairs = 50'000;

std::vector<std::string> materials() {
  return {
      R"({"model": "lambertian", "parameters": {"rd": 0.7}})",
      R"({"model": "oren_nayar", "parameters": {"rd": 0.8, "sigma": 0.4}})",
      R"({"model": "oren_nayar", "parameters": {"rd": 0.5, "sigma": 0.9, "form": "short"}})",
      R"({"model": "ashikhmin_shirley", "parameters": {"nu": 1000, "nv": 10, "rs": 0.3, "rd": 0.4}})",
      R"({"model": "ashikhmin_shirley", "parameters": {"nu": 1e6, "nv": 1e6, "rs": 0.9, "rd": 0}})",
      R"({"model": "cook_torrance", "parameters": {"m": 0.3, "f0": 0.05}})",
      R"({"model": "cook_torrance", "parameters": {"m": 0.003, "eta": 1.5}})",
      R"({"model": "cook_torrance", "parameters": {"m": 0.2, "eta": 0.66}})",
      R"({"model": "cook_torrance", "parameters": {"s": 5000, "eta": 0.2, "k": 3.4}})",
      R"({"model": "ggx", "parameters": {"alpha_x": 0.4, "alpha_y": 0.05, "f0": 0.9}})",
      R"({"model": "ggx", "parameters": {"alpha_x": 0.001, "alpha_y": 0.001, "eta": 1.0001}})",
      R"({"model": "ggx", "parameters": {"alpha_x": 1, "alpha_y": 1, "eta": 2.9, "k": 3}})",
      R"({"model": "phong", "parameters": {"s": 0.5}})",
      R"({"model": "phong", "parameters": {"s": 1e5, "eta": 1.3}})",
      R"({"model": "blinn_phong", "parameters": {"s": 40, "f0": 0.2}})",
      R"({"model": "blinn_phong", "parameters": {"s": 1e6}})",
      R"({"model": "phong_mix", "parameters": {"s": 300, "mix": 0.7, "f0": 0.5}})",
      R"({"model": "ward", "parameters": {"alpha_x": 0.01, "alpha_y": 0.2}})",
      R"({"model": "ward", "parameters": {"alpha_x": 0.3, "alpha_y": 0.3}})",
      R"({"diffuse": {"model": "lambertian", "parameters": {"rd": 0.2}},
          "specular": [{"model": "ggx", "parameters": {"alpha_x": 0.1, "alpha_y": 0.1}},
                       {"model": "phong", "parameters": {"s": 20}}]})"};
}

// Half of them anywhere, half about half-vectors at all distances from the normal, where lobes are.
template <class T>
struct RandomPairs {
  std::vector<T> wi, wo;

  RandomPairs(std::size_t count, unsigned seed) : random_(seed) {
    for (std::size_t i = 0; i < count; ++i) i % 2 == 0 ? anywhere() : lobe();
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  Direction hemisphere() {
    return spherical(std::acos(uniform()), 6.28318530717958648 * uniform());
  }
  void add(const Direction& i, const Direction& o) {
    for (const double x : i) wi.push_back(static_cast<T>(x));
    for (const double x : o) wo.push_back(static_cast<T>(x));
  }
  void anywhere() {
    const Direction i = hemisphere();
    add(i, hemisphere());
  }
  void lobe() {
    const Direction i = hemisphere();
    const Direction h = spherical(std::pow(10, -5 * uniform()), 6.28318530717958648 * uniform());
    const double twice = 2 * (i[0] * h[0] + i[1] * h[1] + i[2] * h[2]);
    add(i, {twice * h[0] - i[0], twice * h[1] - i[1], twice * h[2] - i[2]});
  }

  std::mt19937 random_;
};

// Counts what a bound of a reply speaks of, and what does not keep it.
class Bounds : public ::testing::TestWithParam<std::string> {
 protected:
  Bounds()
      : message_(*wire::material_from_json(GetParam())),
        truth_(*build_material(message_, "material.", {})) {}

  // `of_cosine`: the value is f cos(theta_o).
  template <class T>
  void hold(const T* wi, const T* wo, double value, const v1::ErrorBound& bound, double rounding,
            bool of_cosine) {
    ++evaluations_;
    if (!(std::min(wi[2], wo[2]) > static_cast<T>(bound.cosine()))) return;
    long double f = 0;
    truth_.evaluate({wi[0], wi[1], wi[2]}, {wo[0], wo[1], wo[2]}, {&f, 1});
    if (of_cosine) {
      f *= wo[2] / std::hypot(static_cast<long double>(wo[0]), static_cast<long double>(wo[1]),
                              static_cast<long double>(wo[2]));
    }
    if (!(f > bound.above()) || f > std::numeric_limits<float>::max()) return;
    ++held_;
    const auto error = static_cast<double>(std::abs(value - f) / f);
    worst_ = std::max(worst_, error / (bound.relative() + rounding));
    if (!(error <= bound.relative() + rounding)) ++violations_;
  }

  template <class T>
  void evaluate(unsigned seed) {
    const RandomPairs<T> pairs(kPairs, seed);
    v1::EvaluateRequest request;
    *request.mutable_material() = message_;
    const auto add = [](auto* to, const std::vector<T>& from) {
      to->Add(from.begin(), from.end());
    };
    if constexpr (sizeof(T) == sizeof(float)) {
      add(request.mutable_pairs()->mutable_wi(), pairs.wi);
      add(request.mutable_pairs()->mutable_wo(), pairs.wo);
    } else {
      request.set_precision(v1::PRECISION_REFERENCE);
      add(request.mutable_pairs_f64()->mutable_wi(), pairs.wi);
      add(request.mutable_pairs_f64()->mutable_wo(), pairs.wo);
    }
    const auto reply = server_.evaluated(request);
    const auto value = [&](std::size_t i) {
      return sizeof(T) == sizeof(float) ? static_cast<double>(reply.values(static_cast<int>(i)))
                                        : reply.values_f64(static_cast<int>(i));
    };
    for (std::size_t i = 0; i < kPairs; ++i) {
      hold(&pairs.wi[3 * i], &pairs.wo[3 * i], value(i), reply.report().error_bound(), 0, false);
    }
  }

  // A weight, a pdf and their product: each a rounding of float32 beside the bound of f.
  void sample(unsigned seed) {
    constexpr std::size_t kWi = 50;
    v1::SampleRequest request = sample_request(random_directions(kWi, seed), kPairs / kWi);
    *request.mutable_material() = message_;
    request.set_seed(seed);
    const auto reply = sampled(server_, request);
    for (std::size_t i = 0; i < kPairs; ++i) {
      const auto at = static_cast<int>(i);
      if (!reply.flags().empty() && reply.flags()[i] != 0) continue;
      hold(&request.wi().Get(static_cast<int>(3 * (i / (kPairs / kWi)))), &reply.wo().Get(3 * at),
           static_cast<double>(reply.weights(at)) * static_cast<double>(reply.pdf(at)),
           reply.report().error_bound(), 4 * 0x1p-23, true);
    }
  }

  TestServer server_;
  v1::Material message_;
  Truth truth_;
  std::size_t evaluations_ = 0, held_ = 0, violations_ = 0;
  double worst_ = 0;
};

TEST_P(Bounds, OfRepliesAreKept) {
  for (int round = 0; round < kRounds; ++round) {
    const auto seed = static_cast<unsigned>(round + 1);
    if (round % 3 != 2) evaluate<float>(seed);
    if (round % 3 == 2) evaluate<double>(seed);
    if (round % 8 == 0) sample(seed);
  }
  RecordProperty("evaluations", std::to_string(evaluations_));
  std::cout << evaluations_ << " evaluations, of which the bounds speak of " << held_
            << "; the worst error is " << worst_ << " of its bound\n";
  EXPECT_EQ(violations_, 0U);
  EXPECT_GT(held_, evaluations_ / 8);
  EXPECT_GE(evaluations_ * materials().size(), kRounds == 1 ? 1U : 10'000'000U);
}

INSTANTIATE_TEST_SUITE_P(Materials, Bounds, ::testing::ValuesIn(materials()),
                         [](const auto& material) {
                           return "of_" + std::to_string(material.index);
                         });

}  // namespace
}  // namespace gonio::server::testing
