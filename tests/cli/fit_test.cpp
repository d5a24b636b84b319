// `gonio fit` and `gonio compare` as users see them: data in, material, table and report out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cli/support/fit_fixture.h"
#include "cli/support/json_text.h"
#include "cli/support/run_process.h"
#include "data_folder.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const google::protobuf::Value& at(const google::protobuf::Struct& object, const std::string& name) {
  return object.fields().at(name);
}

TEST_F(FitCommand, FindsTheMaterialThatMadeTheData) {
  const auto result =
      run("gonio fit --data $D/data.csv --deg --model ggx:schlick -o $D/fit.json --report "
          "$D/report.json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("4896 pairs"), HasSubstr("ggx:schlick"),
                                HasSubstr("specular[0].alpha_x 0.15 +-"), HasSubstr("CPU s")));
  EXPECT_THAT(result.err, IsEmpty());
  const auto material = json(content("fit.json"));
  const auto& lobe = at(material, "specular").list_value().values(0).struct_value();
  const auto& parameters = at(lobe, "parameters").struct_value();
  EXPECT_NEAR(at(parameters, "alpha_x").number_value(), 0.15, 1e-3);
  const auto& base = at(at(material, "diffuse").struct_value(), "parameters").struct_value();
  EXPECT_NEAR(at(base, "rd").list_value().values(0).number_value(), 0.3, 1e-3);
  const auto report = json(content("report.json"));
  const auto& fit = at(report, "fits").list_value().values(0).struct_value();
  EXPECT_EQ(at(fit, "model").string_value(), "ggx:schlick");
  const auto& certificate = at(at(fit, "result").struct_value(), "certificate").struct_value();
  EXPECT_LT(
      at(at(at(certificate, "errors").struct_value(), "all").struct_value(), "l1").number_value(),
      1e-3);

  const auto compared =
      run("gonio compare --reference $D/data.csv --deg --material $D/truth.json $D/fit.json");
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_THAT(compared.out,
              AllOf(HasSubstr("truth.json"), HasSubstr("fit.json"), HasSubstr("mirror")));
}

TEST_F(FitCommand, WithoutABaseAModelIsFittedAlone) {
  write_file(folder_ / "as.json", R"({"model": "ashikhmin_shirley", "parameters":
      {"rd": [0.3, 0.2, 0.1], "rs": [0.2, 0.1, 0.1], "nu": 40, "nv": 40}})");
  const auto result = run(
      "gonio evaluate --material $D/as.json --deg --with-input --grid "
      "theta_i=5:75:8,theta_o=0:80:17,phi_o=0:350:36 -o $D/as.csv && gonio fit --data $D/as.csv "
      "--deg --model ashikhmin_shirley --base none -o $D/alone.json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto material = json(content("alone.json"));
  EXPECT_EQ(at(material, "model").string_value(), "ashikhmin_shirley");
  const auto& parameters = at(material, "parameters").struct_value();
  EXPECT_NEAR(at(parameters, "nu").number_value(), 40, 0.1);
  EXPECT_NEAR(at(parameters, "rd").list_value().values(1).number_value(), 0.2, 1e-3);

  const auto two =
      run("gonio fit --data $D/as.csv --deg --model ggx:none --lobes 2 --base none "
          "--starts 1 -o $D/two.json");
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(json(content("two.json")).fields().count("diffuse"), 0);
  EXPECT_EQ(at(json(content("two.json")), "specular").list_value().values_size(), 2);

  const auto wrong = run("gonio fit --data $D/as.csv --deg --model ggx --base ward");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, AllOf(HasSubstr("--base"), HasSubstr("\"ward\""),
                               HasSubstr("lambertian, oren_nayar, none")));
}

TEST_F(FitCommand, OfAllModelsTheBestIsWritten) {
  const auto result = run(
      "gonio fit --data $D/data.csv --deg --model lambertian,ggx:schlick,ward -o - 2> $D/table");
  ASSERT_EQ(result.exit_code, 0) << content("table");
  EXPECT_THAT(result.out, HasSubstr("\"ggx\""));
  json(result.out);
  EXPECT_THAT(content("table"),
              AllOf(HasSubstr("\nlambertian "), HasSubstr("\nggx:schlick "), HasSubstr("\nward ")));
  EXPECT_THAT(run("gonio fit --data $D/data.csv --deg --model lambertian -q").out, IsEmpty());
}

TEST_F(FitCommand, LeavesOutWhatIsFlaggedOrNotMeasured) {
  write_file(folder_ / "some.csv",
             "theta_i,phi_i,theta_o,phi_o,f_0,flags\n0.5,0,0.4,0,0.1,0\n0.5,0,0.4,1,0.1,0\n"
             "0.5,0,0.4,2,0,32\n0.5,0,0.4,3,-1,0\n0.5,0,2,3,1,0\n0.5,0,0.3,3,nan,0\n");
  const auto result = run("gonio fit --data $D/some.csv --model lambertian");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              HasSubstr("2 pairs; left out: 2 not finite, 1 below the horizon, 1 negative"));
}

TEST_F(FitCommand, FailsWithTheReasonAndWritesNothing) {
  write_file(folder_ / "none.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.5,0,0.4,0,nan\n");
  const auto result = run("gonio fit --data $D/none.csv --model lambertian -o $D/none.json");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.out, HasSubstr("failed"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.json"));
}

TEST_F(FitCommand, NamesWhatIsWrong) {
  const auto error_of = [&](const std::string& arguments) {
    const auto result = run("gonio fit " + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.out, IsEmpty());
    return result.err;
  };
  const std::string good = "--data $D/data.csv --deg ";
  EXPECT_THAT(error_of(good + "--model phon"), HasSubstr("\"phon\"; allowed: all, lambertian"));
  EXPECT_THAT(error_of(good + "--model measured"), HasSubstr("allowed: all, lambertian"));
  EXPECT_THAT(error_of(good + "--model ward:schlick"), HasSubstr("takes no Fresnel term"));
  EXPECT_THAT(error_of(good + "--model ggx:glass"), HasSubstr("none, schlick"));
  EXPECT_THAT(error_of(good + "--model ggx --lobes 3"), HasSubstr("--lobes"));
  EXPECT_THAT(error_of(good + "--model ggx --min-theta 80 --max-theta 60"),
              HasSubstr("--min-theta is 80; allowed: 0 to below --max-theta, 60 degrees"));
  for (const char* none : {"0", "nan", "-1", "91"})
    EXPECT_THAT(error_of(good + "--model ggx --max-theta " + none),
                HasSubstr("--max-theta is " + std::string(none) + "; allowed: above 0"));
  EXPECT_THAT(error_of(good + "--model ggx --deadline nan"), HasSubstr("--deadline is nan"));
  EXPECT_THAT(error_of("--data $D/no.csv --model ggx"), HasSubstr("no.csv"));
  EXPECT_THAT(error_of("--data $D/no.binary --model ggx"), HasSubstr("no.binary"));
  EXPECT_THAT(error_of("--data $D/no.brdf --model ggx"), HasSubstr("no such file"));
  write_file(folder_ / "bad.csv", "theta_i,phi_i,theta_o,phi_o\n");
  EXPECT_THAT(error_of("--data $D/bad.csv --model ggx"), HasSubstr("lacks a value f_0"));
  for (const char* stray : {"f_2", "f_64"}) {
    write_file(folder_ / "bad.csv",
               "theta_i,phi_i,theta_o,phi_o,f_0," + std::string(stray) + "\n0,0,0,0,1,1\n");
    EXPECT_THAT(error_of("--data $D/bad.csv --model ggx"),
                HasSubstr("the header has " + std::string(stray) + " beyond f_63 or after"));
  }
  write_file(folder_ / "bad.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0,0,0,0\n");
  EXPECT_THAT(error_of("--data $D/bad.csv --model ggx"),
              HasSubstr("bad.csv:2: fewer than the 5 columns"));
  write_file(folder_ / "bad.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0,0,x,0,1\n");
  EXPECT_THAT(error_of("--data $D/bad.csv --model ggx"),
              HasSubstr("column 3 (theta_o): 'x' is not"));
}

TEST_F(FitCommand, CannotWriteIntoAFolderThatIsNotThere) {
  const auto result =
      run("gonio fit --data $D/data.csv --deg --model lambertian -o $D/no/such/folder.json");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("folder.json"));
  EXPECT_THAT(result.out, IsEmpty());
}

TEST_F(FitCommand, AsksAServer) {
  const auto result =
      run("gonio fit --server unix:$D/nobody --data $D/data.csv --deg --model lambertian -o "
          "$D/fit.json");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "fit.json"));
}

TEST_F(FitCommand, SaysThatTapesReflectTowardTheLight) {
  const auto file = gonio::testing::data_folder() / "retro" / "retro-gray-tape.dat";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const auto result = run("gonio fit --data '" + file.string() + "' --model phong");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("lobe toward the light"));
}

TEST_F(FitCommand, CompareNamesWhatIsWrong) {
  const auto two = run(
      R"(gonio compare --reference $D/data.csv --deg -m '{"model": "lambertian", "parameters": {"rd": [0.1, 0.2]}}')");
  EXPECT_EQ(two.exit_code, 2);
  EXPECT_THAT(two.err, HasSubstr("a material of 2 channels; allowed: 1 or 3"));
  EXPECT_EQ(run("gonio compare --reference $D/none.csv -m $D/truth.json").exit_code, 2);
  EXPECT_EQ(run("gonio compare --reference $D/data.csv --deg -m $D/none.json").exit_code, 2);
}

}  // namespace
}  // namespace gonio::test
