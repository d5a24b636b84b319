// The kinds of data that `gonio fit` takes beside CSV.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/support/fit_fixture.h"
#include "cli/support/npy_file.h"
#include "cli/support/run_process.h"
#include "data_folder.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class FitData : public FitCommand {};

TEST_F(FitData, TakesArraysOfNumPy) {
  std::vector<float> rows;
  for (int i = 0; i < 400; ++i) {
    const float c = 0.1F + 0.002F * static_cast<float>(i), s = std::sqrt(1 - c * c);
    rows.insert(rows.end(), {0.6F, 0, 0.8F, 0, s, c, 0.25F, 0.125F});
  }
  const auto write = [&](const std::string& name, const std::string& shape, const auto& numbers) {
    const bool wide = sizeof(numbers[0]) == 8;
    write_file(folder_ / name, npy(wide ? "<f8" : "<f4", "False", shape, bytes_of(numbers)));
  };
  write("narrow.npy", "(400, 8)", rows);
  write("wide.npy", "(400, 8)", std::vector<double>(rows.begin(), rows.end()));
  for (const char* file : {"narrow.npy", "wide.npy"}) {
    const auto result = run(std::string("gonio fit --model lambertian --data $D/") + file);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, AllOf(HasSubstr("400 pairs"), HasSubstr("rd 0.7854 +- "),
                                  HasSubstr(" / 0.3927 +- ")));
  }
  const auto error_of = [&](const std::string& name) {
    const auto result = run("gonio fit --model lambertian --data $D/" + name);
    EXPECT_EQ(result.exit_code, 2) << name;
    return result.err;
  };
  write("six.npy", "(400, 6)", std::vector<float>(2400));
  EXPECT_THAT(error_of("six.npy"),
              HasSubstr("has the shape (400, 6); allowed: an array of float32"));
  write("many.npy", "(2, 71)", std::vector<float>(142));
  EXPECT_THAT(error_of("many.npy"), HasSubstr("has the shape (2, 71)"));
  write("cut.npy", "(401, 8)", rows);
  EXPECT_THAT(error_of("cut.npy"), HasSubstr("ends after 400 of the 401 rows"));
  write("long.npy", "(399, 8)", rows);
  EXPECT_THAT(error_of("long.npy"), HasSubstr("goes on after the 399 rows"));
}

TEST_F(FitData, TakesSpectra) {
  const auto file = gonio::testing::data_folder() / "cornell" / "krylon_blue.brdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const auto result =
      run("gonio fit --data '" + file.string() + "' --model cook_torrance -o $D/blue.json");
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  EXPECT_THAT(result.out, AllOf(HasSubstr("1439 pairs"), HasSubstr("(31 channels)")));
}

TEST_F(FitData, TakesFilesOfTheRglDatabase) {
  const auto file = gonio::testing::data_folder() / "rgl" / "satin_rosaline_rgb.bsdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const auto result = run("gonio fit --data '" + file.string() + "' --model ggx");
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  EXPECT_THAT(result.out, HasSubstr("6780 pairs; left out: 1158 below the horizon"));
  write_file(folder_ / "cut.bsdf", "tensor_file");
  const auto cut = run("gonio fit --data $D/cut.bsdf --model ggx");
  EXPECT_EQ(cut.exit_code, 2);
  EXPECT_THAT(cut.err,
              HasSubstr("cut.bsdf: found 'tensor_file' at its beginning; expected `tensor_file`"));
}

}  // namespace
}  // namespace gonio::test
