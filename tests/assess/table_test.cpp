// Assessments of measured tables: what is wrong with a table fails, by name, and nothing else does.
#include "gonio/measured/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assess/assessed.h"
#include "assess/verdict.h"
#include "measured/merl/cells.h"
#include "measured/merl/review.h"

namespace gonio::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A lobe over a diffuse base, -1 below the horizon; with a fault.
template <class Fault>
std::shared_ptr<const MeasuredTable> table_with(const Fault& fault) {
  std::vector<float> cells(MeasuredTable::kCells * MeasuredTable::kChannels);
  for (int h = 0; h < MeasuredTable::kThetaH; ++h) {
    for (int d = 0; d < MeasuredTable::kThetaD; ++d) {
      const CellCosines cosines(h, d);
      const auto lobe = static_cast<float>(0.8 * std::exp(-std::pow(h / 35.0, 4)));
      for (int p = 0; p < MeasuredTable::kPhiD; ++p) {
        float* f = &cells[Cell{h, d, p}.index() * 3];
        f[0] = f[1] = f[2] = cosines.at(p)[0] > 0 ? 0.05F + lobe : -1;
        fault(Cell{h, d, p}, cosines.at(p), f);
      }
    }
  }
  const auto table = MeasuredTable::from_values(cells);
  EXPECT_TRUE(table.ok());
  return *table;
}

// The checks of cells alone.
template <class Fault>
assess::Report cells_with(const Fault& fault, const assess::Limits& limits = {}) {
  assess::Report report;
  report.table = review(*table_with(fault));
  assess::set_verdict(limits, report);
  return report;
}

template <class Fault>
assess::Report report_with(const Fault& fault) {
  assess::Options few;
  few.pairs = 20;  // values have tests of their own
  return report_of(subject_of(Material::from_table(table_with(fault), Interpolation::linear)), few);
}
using Cosines = std::array<double, 2>;
void set(float* f, float value) { f[0] = f[1] = f[2] = value; }

TEST(AssessTable, PassesWhatIsGood) {
  const auto report = report_with([](const Cell&, const Cosines&, float*) {});
  EXPECT_THAT(failed(report), IsEmpty());
  EXPECT_EQ(report.checks.size(), 17U);
  EXPECT_EQ(check_of(report, "holes").value, 0);
}

TEST(AssessTable, NothingMeasured) {
  EXPECT_THAT(failed(cells_with([](const Cell&, const Cosines&, float* f) { set(f, -1); })),
              Contains("missing"));
  EXPECT_THAT(failed(cells_with([](const Cell&, const Cosines&, float* f) { set(f, 0); })),
              Contains("zeros"));
  const auto plane = cells_with([](const Cell&, const Cosines&, float* f) { f[2] = -1; });
  EXPECT_THAT(failed(plane), Contains("missing"));
  EXPECT_EQ(check_of(plane, "missing").where, "blue");
  const auto half = cells_with([](const Cell& at, const Cosines&, float* f) {
    if (at.p < 90) set(f, -1);
  });
  EXPECT_THAT(failed(half), Contains("missing_region"));
  EXPECT_THAT(check_of(half, "missing_region").where, HasSubstr("phi_d"));
}

TEST(AssessTable, OneCellOfTenToTheThirty) {
  const auto report = cells_with([](const Cell& at, const Cosines&, float* f) {
    if (at.h == 50 && at.d == 20 && at.p == 33) f[0] = 1e30F;
  });
  EXPECT_THAT(failed(report), Contains("outlier"));
  EXPECT_THAT(failed(report), Contains("extreme"));
  EXPECT_THAT(check_of(report, "extreme").where, HasSubstr("theta_d 20.5"));
}

// Light from the normal meets nothing but masked cells: no incidence that is tried gains.
TEST(AssessTable, MaskedNormal) {
  const auto masked = [](const Cell&, const Cosines& cosines, float* f) {
    if (cosines[1] > 0.99985) set(f, 0);
  };
  EXPECT_THAT(failed(cells_with(masked)), Contains("holes"));
  assess::Limits limits;
  limits.holes = 1;
  EXPECT_THAT(failed(cells_with(masked, limits)), IsEmpty());
}

// Beside the horizon cells that it cuts are carried on by interpolation: shown, and not judged
// unless a limit is given.
TEST(AssessTable, GainBesideTheHorizonIsNotJudged) {
  const auto grazing = [](const Cell&, const Cosines& cosines, float* f) {
    if (cosines[0] > 0 && cosines[0] < 0.03)
      set(f, static_cast<float>(1 / std::max(cosines[0], 0.02)));
  };
  assess::Report report = report_with(grazing);
  EXPECT_TRUE(check_of(report, "energy_gain").passed);
  EXPECT_THAT(check_of(report, "energy_gain").note, HasSubstr("89.9 deg, where the horizon cuts"));
  assess::Limits given;
  given.gain = 1e-3;
  assess::set_verdict(given, report);
  EXPECT_FALSE(check_of(report, "energy_gain").passed);
  const auto bright = [](const Cell&, const Cosines& cosines, float* f) {
    if (cosines[0] > 0) set(f, 0.5F);
  };
  EXPECT_FALSE(check_of(report_with(bright), "energy_gain").passed);
}

}  // namespace
}  // namespace gonio::testing
