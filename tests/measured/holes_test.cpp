// Cells without a measurement, and pairs that meet them; what a review of all cells finds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/batches.h"
#include "engine/material/hole_share.h"
#include "gonio/engine/sampler.h"
#include "measured/merl/cells.h"
#include "measured/merl/review.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using TablePtr = std::shared_ptr<const MeasuredTable>;

// A lobe over a diffuse base, -1 below the horizon, as a measured table has it; with a fault.
template <class Fault>
TablePtr table_with(const Fault& fault) {
  std::vector<float> values = tabulate([](double h, double d, double p) {
    const double across = std::sin(h) * std::sin(d) * std::cos(p),
                 along = std::cos(h) * std::cos(d);
    if (std::abs(across) >= along) return Rgb{-1, -1, -1};
    const double lobe = 20 * std::exp(-std::pow(h / 0.2, 2));
    return Rgb{0.1 + lobe, 0.05 + lobe, 0.02 + lobe};
  });
  for (int h = 0; h < 90; ++h) {
    for (int d = 0; d < 90; ++d) {
      for (int p = 0; p < 180; ++p) fault(Cell{h, d, p}, &values[3 * Cell{h, d, p}.index()]);
    }
  }
  return *MeasuredTable::from_values(values);
}
TablePtr good() {
  return table_with([](const Cell&, float*) {});
}
// As the database's compact form has it: light or view within a degree of the normal is masked.
TablePtr masked() {
  return table_with([](const Cell& at, float* f) {
    if (CellCosines(at.h, at.d).at(at.p)[1] > std::cos(std::numbers::pi / 180))
      f[0] = f[1] = f[2] = 0;
  });
}

TEST(Holes, OfAGoodTableAreNone) {
  EXPECT_EQ(good()->holes().count, 0U);
  EXPECT_THAT(good()->holes().around, IsEmpty());
  const TableReview found = review(*good());
  EXPECT_GT(found.cells, 400'000U);
  for (const CellFinding& f : {found.missing, found.missing_region, found.zeros, found.holes}) {
    EXPECT_EQ(f.value, 0);
    EXPECT_THAT(f.where, IsEmpty());
  }
  EXPECT_LT(found.outlier.value, 2);
  EXPECT_LT(found.extreme.value, 25);
}

TEST(Holes, AreInvalidAndMaskedCells) {
  const auto one = [](float value) {
    return table_with([value](const Cell& at, float* f) {
      if (at.h == 9 && at.d == 30 && at.p == 40) f[0] = f[1] = f[2] = value;
    });
  };
  for (const float value : {-1.F, 0.F, 0.01F}) {
    const TablePtr table = one(value);
    EXPECT_EQ(table->holes().count, 1U) << value;
    const std::size_t at = Cell{9, 30, 40}.index();
    EXPECT_TRUE(table->holes().cells[at / 64] >> (at % 64) & 1U);
  }
  EXPECT_EQ(one(10)->holes().count, 0U);
  EXPECT_GT(masked()->holes().count, 1000U);
  EXPECT_GT(review(*masked()).holes.value, 1e-3);
}

TEST(Holes, AreFlaggedAndValuesStand) {
  const TablePtr table = masked();
  const auto pairs = random_pairs<float>(4001);
  for (const auto interpolation : {Interpolation::linear, Interpolation::nearest}) {
    const Material material = Material::from_table(table, interpolation);
    for (const Isa isa : supported_isas()) {
      std::vector<float> values(3), alone(3);
      std::uint8_t flags = 0;
      Pairs<float> normal{{0, 0, 1}, {0.6F, 0, 0.8F}};
      EXPECT_EQ(evaluate(material, batch_of(normal, 0, 1, values.data(), 3, &flags), isa),
                flag::hole);
      EXPECT_EQ(flags, flag::hole);
      float pdf = 0;
      evaluate(Sampler::create(material), batch_of(normal, 0, 1, alone.data(), 3, &flags), &pdf,
               isa);
      EXPECT_TRUE(same_bits(values.data(), alone.data(), 3));
      EXPECT_GT(pdf, 0);  // it is drawn as it was
      EXPECT_EQ(flags, flag::hole);
      std::vector<float> many(3 * pairs.size());
      std::vector<std::uint8_t> all(pairs.size());
      evaluate(material, batch_of(pairs, 0, pairs.size(), many.data(), 3, all.data()), isa);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double most = std::max(pairs.wi[3 * i + 2], pairs.wo[3 * i + 2]);
        if (most < std::cos(5 * std::numbers::pi / 180)) {
          ASSERT_EQ(all[i] & flag::hole, 0) << i;
        }
      }
    }
  }
}

// At the horizon cells that cannot be measured are no holes.
TEST(Holes, AreNotBelowTheHorizon) {
  const Material material = Material::from_table(good(), Interpolation::linear);
  Pairs<double> grazing{{std::sqrt(1 - 1e-4), 0, 1e-2}, {0, std::sqrt(1 - 1e-4), 1e-2}};
  std::vector<double> values(3);
  EXPECT_EQ(evaluate(material, batch_of(grazing, 0, 1, values.data(), 3, nullptr), best_isa()), 0);
}

TEST(Holes, ShareOfTheHemisphere) {
  const auto share = [](const TablePtr& table, double theta) {
    return hole_share(Material::from_table(table, Interpolation::linear),
                      {std::sin(theta), 0, std::cos(theta)}, best_isa());
  };
  EXPECT_EQ(share(good(), 0), 0);
  EXPECT_EQ(share(masked(), 0), 1);
  EXPECT_LT(share(masked(), 0.5), 0.05);
}

TEST(Review, FindsWhatIsMissing) {
  const auto half = table_with([](const Cell& at, float* f) {
    if (at.p >= 90) f[0] = f[1] = f[2] = -1;
  });
  EXPECT_NEAR(review(*half).missing.value, 0.5, 0.01);
  EXPECT_EQ(review(*half).missing_region.value, 1);
  EXPECT_EQ(review(*half).missing_region.where, "phi_d 90 to 100 deg");
  const auto plane = table_with([](const Cell&, float* f) { f[1] = -1; });
  EXPECT_EQ(review(*plane).missing.value, 1);
  EXPECT_EQ(review(*plane).missing.where, "green");
  const auto dark = table_with([](const Cell&, float* f) { f[2] = std::min(f[2], 0.F); });
  EXPECT_EQ(review(*dark).zeros.value, 1);
  EXPECT_EQ(review(*dark).zeros.where, "blue");
}

TEST(Review, FindsWhatStandsOut) {
  const auto with = [](float value, int cells) {
    return review(*table_with([=](const Cell& at, float* f) {
      if (at.h == 40 && at.d == 30 && at.p >= 50 && at.p < 50 + cells) f[1] = value;
    }));
  };
  EXPECT_GT(with(1e4F, 1).outlier.value, 1000);
  EXPECT_THAT(with(1e4F, 1).outlier.where, HasSubstr("theta_d 30.5, phi_d 50.5 degrees, green"));
  EXPECT_GT(with(1e4F, 2).outlier.value, 1000);   // next to each other
  EXPECT_GT(with(1e4F, 60).outlier.value, 1000);  // a stripe
  EXPECT_GT(with(1e30F, 60).extreme.value, 1e28);
}

}  // namespace
}  // namespace gonio::testing
