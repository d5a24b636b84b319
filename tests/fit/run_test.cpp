// A fit as a job: the same every time, stopped when asked, heard from meanwhile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "effort.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using Clock = WorkClock;
using Numbers = std::vector<double>;

const MaterialSpec kTruth{
    {},
    LobeSpec{"lambertian", {{"rd", Numbers{0.3, 0.1, 0.05}}}},
    {LobeSpec{"cook_torrance",
              {{"m", Numbers{0.2}}, {"eta", Numbers{1.6}}, {"fresnel", "dielectric"}}}}};

const fit::Data& noisy_data() {
  static const fit::Data data = data_of(kTruth, scattered_pairs(6000, 1), 0.1);
  return data;
}

TEST(FitRun, IsTheSameOnEveryThread) {
  fit::Options options;
  options.fit_pairs = 3000;
  std::array<Result<fit::FitResult>, 3> results{Error{}, Error{}, Error{}};
  const auto run = [&](std::size_t i) {
    results[i] = fit::fit(noisy_data(), form_of(kTruth), options);
  };
  run(0);
  std::thread other([&] { run(1); });
  run(2);
  other.join();
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(results[i]->material.specular[0].parameters,
              results[0]->material.specular[0].parameters);
    EXPECT_EQ(results[i]->material.diffuse->parameters, results[0]->material.diffuse->parameters);
    EXPECT_EQ(results[i]->certificate.errors.all.l1, results[0]->certificate.errors.all.l1);
    EXPECT_EQ(results[i]->certificate.parameters[0].standard_error,
              results[0]->certificate.parameters[0].standard_error);
  }
  options.seed = 2;
  const auto another = fit::fit(noisy_data(), form_of(kTruth), options);
  EXPECT_NE(another->certificate.stages.back().objective,
            results[0]->certificate.stages.back().objective);
}

// A guess that leads nowhere leaves the very material that is found without one; none makes it
// worse.
TEST(FitRun, IsNotHarmedByAGuess) {
  const auto without = fit::fit(noisy_data(), form_of(kTruth), {});
  EXPECT_FALSE(without->certificate.starts.back().given);
  for (const double m : {1e-3, 0.01, 0.6, 2.0}) {
    MaterialSpec form = form_of(kTruth);
    form.specular[0].parameters["m"] = Numbers{m};
    form.specular[0].parameters["eta"] = Numbers{90};
    const auto with = fit::fit(noisy_data(), form, {});
    const fit::Start& guess = with->certificate.starts.back();
    EXPECT_TRUE(guess.given);
    EXPECT_NEAR(guess.from[0], m, 1e-9);
    EXPECT_LE(with->certificate.stages.back().objective,
              without->certificate.stages.back().objective);
    if (m > 1e-3) continue;
    EXPECT_EQ(with->material.specular[0].parameters, without->material.specular[0].parameters);
  }
}

TEST(FitRun, StopsWhenAsked) {
  for (const int allowed : {0, 100, 1000, 3000}) {
    int asked = 0;
    Clock::time_point said;
    fit::Watch watch;
    watch.stop = [&] {
      if (++asked <= allowed) return false;
      if (asked == allowed + 1) said = Clock::now();
      return true;
    };
    const auto result = fit::fit(noisy_data(), form_of(kTruth), {}, watch);
    const auto waited = Clock::now() - said;
    if (asked <= allowed) continue;  // it was done before
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    EXPECT_LT(waited, std::chrono::milliseconds(200)) << allowed;
  }
}

TEST(FitRun, TellsOfItsProgress) {
  std::vector<std::string> stages;
  double last = 1e300;
  fit::Watch watch;
  watch.progress = [&](const fit::Progress& p) {
    if (stages.empty() || stages.back() != p.stage) {
      stages.emplace_back(p.stage);
      last = 1e300;
    }
    EXPECT_LE(p.best, last);
    EXPECT_LE(p.best, p.objective);
    last = p.best;
  };
  fit::Options options;
  options.polish = true;
  ASSERT_TRUE(fit::fit(noisy_data(), form_of(kTruth), options, watch).ok());
  EXPECT_EQ(stages, (std::vector<std::string>{"scan", "starts", "fit", "polish"}));
}

TEST(FitRun, NamesWhatIsWrong) {
  const auto field_of = [](const MaterialSpec& form, const fit::Options& options) {
    const auto result = fit::fit(noisy_data(), form, options);
    return result ? std::string() : result.error().field;
  };
  const MaterialSpec form = form_of(kTruth);
  fit::Options options;
  options.max_theta = 2;
  EXPECT_EQ(field_of(form, options), "options.max_theta");
  options = {};
  options.min_theta = 1.6;
  EXPECT_EQ(field_of(form, options), "options.min_theta");
  options = {};
  options.huber = 0;
  EXPECT_EQ(field_of(form, options), "options.huber");
  options = {};
  options.starts = 0;
  EXPECT_EQ(field_of(form, options), "options.starts");
  MaterialSpec wrong = form;
  wrong.specular[0].parameters["m"] = Numbers{7};
  EXPECT_EQ(field_of(wrong, {}), "specular[0].parameters.m");
  EXPECT_EQ(field_of({}, {}), "material");
  EXPECT_EQ(field_of({LobeSpec{"measured", {}}, {}, {}}, {}), "model");
}

}  // namespace
}  // namespace gonio::testing
