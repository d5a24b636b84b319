// The harness finds what it is there to find: errors of every kind, planted in every model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/harness/harness.h"

namespace gonio::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

// Values with an error planted in both precisions.
template <class Error>
Subject with_values(Subject subject, const Error& error) {
  const auto plant = [error](const auto& original) {
    return [=](const MaterialSpec& spec, const auto& pairs, Isa isa) {
      auto values = original(spec, pairs, isa);
      const std::size_t channels = values.size() / pairs.size();
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& pair = pairs[i / channels];
        using T = std::remove_cvref_t<decltype(values[0])>;
        if (pair.wi[2] > 0 && pair.wo[2] > 0)
          values[i] = static_cast<T>(error(pair, static_cast<double>(values[i])));
      }
      return values;
    };
  };
  subject.fast = plant(subject.fast);
  subject.reference = plant(subject.reference);
  return subject;
}

class Planted : public ::testing::TestWithParam<std::string> {
 protected:
  template <class Error>
  [[nodiscard]] Subject with(const Error& error) const {
    return with_values(subject_, error);
  }
  const Subject subject_ = library_subject(GetParam());
};

TEST_P(Planted, FactorIsFound) {
  const auto subject = with([](const auto&, double f) { return 1.001 * f; });
  EXPECT_THAT(check_accuracy(subject), Not(IsEmpty()));
}

// What a formula gives that takes n.wi where n.wo should stand.
TEST_P(Planted, SwappedDirectionIsFound) {
  const auto subject = with([](const auto& pair, double f) {
    return f * (2 + static_cast<double>(pair.wi[2])) / (2 + static_cast<double>(pair.wo[2]));
  });
  EXPECT_THAT(check_reciprocity(subject), Not(IsEmpty()));
}

TEST_P(Planted, WrongClampIsFound) {
  const auto subject = with([](const auto&, double f) { return std::max(f, 1e-6); });
  EXPECT_THAT(check_accuracy(subject), Not(IsEmpty()));
}

// A clamp that works with the wrong sign lets negative values through.
TEST_P(Planted, MissingClampIsFound) {
  const auto subject = with([](const auto&, double f) { return f - 1e-6; });
  EXPECT_THAT(check_proper(subject, 1), Not(IsEmpty()));
}

TEST_P(Planted, DivisionByZeroIsFound) {
  const auto subject = with([](const auto& pair, double f) {
    const auto x = static_cast<double>(pair.wi[0] + pair.wo[0]);
    const auto y = static_cast<double>(pair.wi[1] + pair.wo[1]);
    return f * (x * x + y * y) / (x * x + y * y);  // 0/0 where h = n
  });
  EXPECT_THAT(check_proper(subject, 1), Not(IsEmpty()));
}

TEST_P(Planted, DifferenceOfThePrecisionsIsFound) {
  Subject subject = with([](const auto&, double f) { return 1.00001 * f; });
  subject.reference = subject_.reference;
  EXPECT_THAT(check_proper(subject, 1), Not(IsEmpty()));
}

TEST_P(Planted, PreferredAzimuthIsFound) {
  const auto subject = with([](const auto& pair, double f) {
    return f * (1 + 0.01 * static_cast<double>(pair.wi[0] * pair.wo[0]));
  });
  EXPECT_THAT(check_rotation(subject), Not(IsEmpty()));
}

TEST_P(Planted, JumpIsFound) {
  const auto subject =
      with([](const auto& pair, double f) { return pair.wi[2] < pair.wo[2] ? 1.001 * f : f; });
  EXPECT_THAT(check_continuity(subject), Not(IsEmpty()));
}

TEST_P(Planted, EnergyIsFound) {
  const double factor = 3 * subject_.description.albedo_limit;
  const auto subject = with([&](const auto&, double f) { return factor * f; });
  EXPECT_THAT(check_energy(subject), Not(IsEmpty()));
}

TEST_P(Planted, WrongDerivativeIsFound) {
  Subject subject = subject_;
  for (const Parameter& p : subject.description.parameters) {
    if (p.type == ParameterType::word) continue;
    subject.derivative = [&](const auto& spec, const std::string& by, const auto& pairs, Isa isa) {
      auto values = subject_.derivative(spec, by, pairs, isa);
      for (double& v : values) v *= by == p.name ? 1.001 : 1;
      return values;
    };
    EXPECT_THAT(check_derivatives(subject), Not(IsEmpty())) << p.name;
  }
}

TEST_P(Planted, WrongBoundIsFound) {
  Subject subject = subject_;
  std::vector<Parameter> parameters(subject.description.parameters.begin(),
                                    subject.description.parameters.end());
  parameters.front().lower = parameters.front().upper;
  parameters.front().words = {};
  subject.description.parameters = parameters;
  EXPECT_THAT(check_description(subject), Not(IsEmpty()));
}

INSTANTIATE_TEST_SUITE_P(Models, Planted, ::testing::ValuesIn(analytic_models()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace gonio::testing
