// Every model against the oracle: more than 10,000 hard pairs for each of its cases, on every
// instruction set and in every precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include "gonio/engine/registry.h"
#include "models/harness/compare.h"
#include "models/oracle/cases.h"
#include "models/oracle/run.h"
#include "models/oracle/truth.h"

namespace gonio::testing {
namespace {

// What is promised for f > kAbove; a model's own bound may be tighter.
double promised(Precision precision, Sharpness sharpness) {
  if (precision == Precision::fast) return 3e-6;
  return sharpness == Sharpness::smooth ? 3e-11 : 3e-9;
}

struct Summary {
  double worst = 0, p999 = 0, extreme = 0;
  std::size_t checked = 0;
};

class Accuracy : public ::testing::TestWithParam<std::string> {
 protected:
  void TearDown() override {
    std::ostringstream table;
    table << std::scientific << std::setprecision(2);
    for (const auto& [name, s] : summaries_) {
      table << std::left << std::setw(40) << GetParam() + " " + name << " worst " << s.worst
            << "  99.9 % " << s.p999 << "  extreme " << s.extreme << "  of " << s.checked
            << " values\n";
      RecordProperty("worst " + name, std::to_string(s.worst * 1e12) + "e-12");
      RecordProperty("99.9 % " + name, std::to_string(s.p999 * 1e12) + "e-12");
    }
    std::cout << table.str();
  }

  // One case, one kind of input and output, every instruction set.
  template <class Out, class In>
  void check(const Case& c, const std::vector<DirectionPair<In>>& pairs,
             const std::vector<Quad>& truth, const std::vector<double>& unsure) {
    const Material material = material_of(c.spec);
    ASSERT_EQ(truth.size(), pairs.size() * static_cast<std::size_t>(material.channels()));
    const auto precision = sizeof(Out) == sizeof(float) ? Precision::fast : Precision::reference;
    const ErrorBound stated = material.error_bound(precision);
    for (const Isa isa : supported_isas()) {
      const std::vector<Out> got = library_values<Out>(material, pairs, isa);
      const Comparison result = compare<Out>(got, truth, kAbove, unsure);
      const auto pair_text = [&](std::size_t value) {
        return describe(c, isa, pairs, value, static_cast<Quad>(got[value]), truth[value]);
      };
      for (std::size_t i = 0; i < got.size(); ++i) {
        const auto& pair = pairs[i / (got.size() / pairs.size())];
        if (pair.wi[2] > 0 && pair.wo[2] > 0) continue;
        ASSERT_EQ(got[i], 0) << pair_text(i);
      }
      if (result.improper_at) ADD_FAILURE() << result.improper << pair_text(*result.improper_at);
      const double limit = c.sharpness == Sharpness::extreme
                               ? stated.relative
                               : std::min(stated.relative, promised(precision, c.sharpness));
      EXPECT_LE(result.worst, limit) << pair_text(result.worst_at);
      note(c, isa, sizeof(In) == sizeof(float) ? "float32" : "float64", precision, result);
    }
  }

 private:
  void note(const Case& c, Isa isa, const std::string& input, Precision precision,
            const Comparison& result) {
    Summary& s = summaries_[std::string(name_of(isa)) + " " + std::string(name_of(precision)) +
                            " of " + input];
    s.checked += result.checked;
    double& worst = c.sharpness == Sharpness::extreme ? s.extreme : s.worst;
    worst = std::max(worst, result.worst);
    if (c.sharpness != Sharpness::extreme) s.p999 = std::max(s.p999, result.p999);
  }

  template <class In>
  std::string describe(const Case& c, Isa isa, const std::vector<DirectionPair<In>>& pairs,
                       std::size_t value, Quad got, Quad want) const {
    const std::size_t channels = Oracle<Quad>(c.spec).channels();
    const auto& pair = pairs[value / channels];
    std::ostringstream out;
    out << std::setprecision(17) << "\n  " << GetParam() << ", " << c.name << ", " << name_of(isa)
        << ", channel " << value % channels << ", " << name_of(pair.kind);
    for (const auto& w : {pair.wi, pair.wo}) {
      out << "\n  " << w[0] << ", " << w[1] << ", " << w[2];
    }
    out << "\n  got  " << text(got) << "\n  want " << text(want);
    return out.str();
  }

  std::map<std::string, Summary> summaries_;
};

TEST_P(Accuracy, HoldsAgainstTheOracle) {
  std::uint64_t seed = 1;
  for (const Case& c : cases_of(GetParam())) {
    const auto floats = hard_pairs<float>(++seed);
    ASSERT_GE(floats.size(), 10000U);
    std::vector<Quad> truth = truth_of(c.spec, floats);
    check<float>(c, floats, truth, unsure_of(c.spec, Precision::fast, floats, truth));
    check<double>(c, floats, truth, unsure_of(c.spec, Precision::reference, floats, truth));
    // The same lines with another way to load: fewer will do.
    auto doubles = hard_pairs<double>(++seed);
    std::shuffle(doubles.begin(), doubles.end(), std::mt19937_64(seed));
    doubles.resize(4000);
    truth = truth_of(c.spec, doubles);
    check<double>(c, doubles, truth, unsure_of(c.spec, Precision::reference, doubles, truth));
  }
}

// Where squares of the cosines leave the range of float64, values are still proper ones.
TEST_P(Accuracy, StaysProperAtTheSmallestNumbers) {
  std::vector<DirectionPair<double>> pairs;
  for (const double a : {5e-324, 1e-309, 1e-200, 1e-150, 1e-100, 1e-30, 0.6}) {
    for (const double b : {5e-324, 1e-309, 1e-200, 1e-150, 1e-100, 1e-30, 0.6}) {
      for (const double x : {1.0, -0.8, 0.8}) {
        const auto at = [](double cos, double side) {
          const double sin = std::sqrt(1 - cos * cos);
          return std::array<double, 3>{sin * side, sin * std::sqrt(1 - side * side), cos};
        };
        pairs.push_back({at(a, 0.8), at(b, x), PairKind::tiny_z});
        // Nearly opposite: H is the cosines alone.
        const auto wi = at(a, x);
        pairs.push_back({wi, {-wi[0], -wi[1], b}, PairKind::tiny_z});
      }
    }
  }
  for (const Case& c : cases_of(GetParam())) {
    const Material material = material_of(c.spec);
    for (const Isa isa : supported_isas()) {
      for (const double v : library_values<double>(material, pairs, isa)) {
        ASSERT_TRUE(std::isfinite(v) && v >= 0) << c.name << " " << name_of(isa) << " gives " << v;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Accuracy, ::testing::ValuesIn(models_with_cases()),
                         [](const auto& model) { return model.param; });

}  // namespace
}  // namespace gonio::testing
