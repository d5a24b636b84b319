// Where both directions all but lie in the surface and are opposite, the half-vector is what two
// unit vectors leave of each other. The catalogue of hard places meets few such pairs; here are a
// hundred thousand, at the largest exponents.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "engine/truth/truth.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/isa.h"

namespace gonio {
namespace {

struct Pairs {
  std::vector<float> wi, wo;
  [[nodiscard]] std::size_t count() const { return wi.size() / 3; }
  [[nodiscard]] Truth::Direction in(std::size_t i) const {
    return {wi[3 * i], wi[3 * i + 1], wi[3 * i + 2]};
  }
  [[nodiscard]] Truth::Direction out(std::size_t i) const {
    return {wo[3 * i], wo[3 * i + 1], wo[3 * i + 2]};
  }
};

// Pairs with cosines from `least` to a half more, 1e-9 to 4e-8 from opposite for each 1e-6 of them,
// and off unit length.
Pairs nearly_opposite(double least) {
  constexpr std::size_t kPairs = 1 << 17;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  Pairs pairs;
  const auto add = [&](std::vector<float>& to, double azimuth) {
    const double length = 1 + 1.9e-3 * (unit(random) - 0.5);
    const double cosine = least * (1 + 1e-6 + 0.5 * unit(random));
    for (const double x : {std::cos(azimuth), std::sin(azimuth), cosine})
      to.push_back(static_cast<float>(length * x));
  };
  for (std::size_t i = 0; i < kPairs; ++i) {
    const double azimuth = 6.2831853 * unit(random);
    const double off = least * 1e6 * std::exp2(-30 + 6 * unit(random));
    add(pairs.wi, azimuth);
    add(pairs.wo, azimuth + 3.14159265358979 + off);
  }
  return pairs;
}

Material power_of_half_vector(const std::string& model) {
  LobeSpec lobe{model, {}};
  if (model == "ashikhmin_shirley") {
    lobe.parameters["nu"] = lobe.parameters["nv"] = std::vector<double>{1e8};
  } else {
    lobe.parameters["s"] = std::vector<double>{1e7};
  }
  lobe.parameters["scale"] = std::vector<double>{1e6};
  MaterialSpec spec;
  spec.model = lobe;
  return Material::create(spec).value();
}

template <class Out>
long double worst_error(const Material& material, const Pairs& pairs, Isa isa) {
  std::vector<Out> f(pairs.count());
  Batch<float, Out> batch;
  batch.wi = Directions<float>::interleaved(pairs.wi.data());
  batch.wo = Directions<float>::interleaved(pairs.wo.data());
  batch.count = pairs.count();
  batch.values = Values<Out>::interleaved(f.data(), 1);
  evaluate(material, batch, isa);
  const Truth truth(material);
  long double worst = 0;
  for (std::size_t i = 0; i < pairs.count(); ++i) {
    long double want = 0;
    truth.evaluate(pairs.in(i), pairs.out(i), {&want, 1});
    if (want > 1e-30L && want < 1e38L) worst = std::max(worst, std::abs(f[i] / want - 1));
  }
  return worst;
}

class HorizonCorner : public ::testing::TestWithParam<std::string> {};

TEST_P(HorizonCorner, HoldsWhatItsNoteSays) {
  const Material material = power_of_half_vector(GetParam());
  const Pairs pairs = nearly_opposite(1e-6);
  for (const Isa isa : supported_isas()) {
    EXPECT_LE(worst_error<float>(material, pairs, isa), 5e-5L) << name_of(isa);
    EXPECT_LE(worst_error<double>(material, pairs, isa), 5e-8L) << name_of(isa);
  }
}

TEST_P(HorizonCorner, HoldsTheBoundAtCosinesAboveIt) {
  const Material material = power_of_half_vector(GetParam());
  const Pairs pairs = nearly_opposite(1e-4);
  for (const Isa isa : supported_isas()) {
    EXPECT_LE(worst_error<float>(material, pairs, isa),
              material.error_bound(Precision::fast).relative);
    EXPECT_LE(worst_error<double>(material, pairs, isa),
              material.error_bound(Precision::reference).relative);
  }
}

TEST_P(HorizonCorner, IsSaidInTheNote) {
  const Material material = power_of_half_vector(GetParam());
  EXPECT_NE(material.error_bound(Precision::fast)
                .note.find("5e-5 for exponents above 5e4 where both cosines are below 1e-4"),
            std::string::npos);
  EXPECT_NE(material.error_bound(Precision::reference)
                .note.find("5e-8 for exponents above 5e4 where both cosines are below 1e-4"),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(PowersOfTheHalfVector, HorizonCorner,
                         ::testing::Values("ashikhmin_shirley", "blinn_phong", "cook_torrance",
                                           "phong_mix"),
                         [](const auto& at) { return at.param; });

}  // namespace
}  // namespace gonio
