// Encodings of text and forms of numbers as other programs write them, in every kind of file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/support/csv_text.h"
#include "cli/support/run_process.h"
#include "data_folder.h"

namespace gonio::test {
namespace {

using namespace std::string_literals;
using ::gonio::testing::text_case;
using ::testing::HasSubstr;

TEST(Encodings, OfUtf8AloneAreRead) {
  const std::string text = kHeader + rows(3);
  EXPECT_EQ(pairs_of("\xEF\xBB\xBF" + text), "3 pairs");
  EXPECT_EQ(pairs_of("\xEF\xBB\xBF# " + text), "3 pairs");
  for (const std::string& command : {kFit, kEvaluate}) {
    const auto result = shell(command + text_case("utf16_head.csv").string());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("utf16_head.csv is UTF-16 text; allowed: UTF-8"));
  }
  EXPECT_THAT(error_of("\0t\0h\0e"s), HasSubstr("standard input is UTF-16 text"));
}

TEST(Numbers, AsOtherProgramsWriteThem) {
  EXPECT_EQ(pairs_of(kHeader + "+10,0,1.0D+01,180.,+5.0d-01,0\n"), "1 pairs");
  EXPECT_EQ(pairs_of(kHeader + "10,0,10,180,NaN,0\n10,0,10,180,-inf,0\n10,0,10,180,1,0\n"),
            "1 pairs; left out: 2 not finite");
  for (const char* none : {"NA", "1.#QNAN", "0x1p-1", "1 000", "1e", "--1"})
    EXPECT_THAT(error_of(kHeader + "1,2,3,4," + none + ",0\n"),
                HasSubstr("'"s + none + "' is not a number"));
}

TEST(Json, MayBeginWithAByteOrderMark) {
  const std::string bom = "\xEF\xBB\xBF";
  const std::string file = text_case("bom_material.json");
  const auto evaluated = shell("gonio evaluate --grid theta_i=0.5 -m " + file);
  EXPECT_EQ(evaluated.exit_code, 0) << evaluated.err;
  EXPECT_EQ(shell("gonio evaluate --grid theta_i=0.5 -m \"$(cat " + file + ")\"").out,
            evaluated.out);
  EXPECT_EQ(shell("gonio evaluate --grid theta_i=0.5 -m \"$(tail -c +4 " + file + ")\"").out,
            evaluated.out);
  const gonio::testing::TempFolder folder;
  write_file(folder / "scene.json", bom + R"({"theta_i": [0, 60], "them_o": [0, 60]})");
  const std::string select = "gonio select --reference " + file + " --scene ";
  EXPECT_THAT(shell(select + (folder / "scene.json").string()).err,
              HasSubstr("scene.them_o is not a field"));
  write_file(folder / "scene.json", "{\0\"\0t\0"s);
  EXPECT_THAT(shell(select + (folder / "scene.json").string()).err,
              HasSubstr("scene.json is UTF-16 text"));
  write_file(folder / "m.json", "\xFF\xFE{\0}\0"s);
  EXPECT_THAT(shell("gonio evaluate --grid theta_i=0.5 -m " + (folder / "m.json").string()).err,
              HasSubstr("is UTF-16 text"));
}

TEST(Rgl, ValuesSetToZeroAreCounted) {
  const auto file = gonio::testing::data_folder() / "rgl" / "cc_ibiza_sunset_rgb.bsdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const gonio::testing::TempFolder folder;
  const std::string report = folder / "report";
  const auto fit = shell("gonio fit --model lambertian --data " + file.string() + " --report " +
                         report + ".json --report " + report + ".md");
  EXPECT_THAT(fit.err, HasSubstr("746 values below 0 set to 0"));
  EXPECT_THAT(read_file(report + ".json"), HasSubstr("\"raised_to_zero\": 746"));
  EXPECT_THAT(read_file(report + ".md"), HasSubstr("746 values below 0 set to 0"));
  EXPECT_THAT(
      shell("gonio compare -m '{\"model\": \"lambertian\"}' --reference " + file.string()).out,
      HasSubstr("left out, 746 values below 0 set to 0"));
}

}  // namespace
}  // namespace gonio::test
