// `gonio render` and `gonio lobe`: pictures that are whole or not there, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "cli/support/run_process.h"
#include "cli/support/socket_server.h"
#include "client/picture/image/exr.h"
#include "client/picture/image/read.h"
#include "client/picture/image/srgb.h"
#include "client/support/image_files.h"

namespace gonio::test {
namespace {

using image::Image;
using image::Rgb;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string kMaterial =
    R"( --material '{"model": "ggx", "parameters": {"f0": [1, 0.7, 0.3], "alpha_x": 0.3, "alpha_y": 0.1}}' )";
const std::string kRender = "gonio render" + kMaterial;
const std::string kLobe = "gonio lobe" + kMaterial;
const std::string kSmall = "--size 40x30 --spp 4 ";

class Picture : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }
  // What is in the folder, hidden files too.
  [[nodiscard]] std::string listing() const { return shell("ls -A " + path("")).out; }

  void expect_refused(const std::string& line, const std::vector<std::string>& said,
                      int exit_code = 2) const {
    const std::string before = listing();
    const auto result = shell(line);
    EXPECT_EQ(result.exit_code, exit_code) << line;
    EXPECT_THAT(result.out, IsEmpty()) << line;
    EXPECT_THAT(result.err, StartsWith("gonio: error: ")) << line;
    for (const std::string& word : said) EXPECT_THAT(result.err, HasSubstr(word)) << line;
    EXPECT_EQ(listing(), before) << line;
  }

  // A map of 8 x 4 texels.
  static Image map() {
    Image texels(8, 4);
    for (std::size_t i = 0; i < 32; ++i) texels.pixels[i] = Rgb(1, 0.5F, static_cast<float>(i));
    return texels;
  }

  gonio::testing::TempFolder folder_;
};

TEST_F(Picture, HelpSaysEverything) {
  const auto render = shell("gonio render --help");
  EXPECT_EQ(render.exit_code, 0);
  for (const char* word : {"--material",      "--light",     "--light-direction",
                           "--light-theta",   "--light-phi", "--shape",
                           "--size",          "--spp",       "--view-elevation",
                           "--field-of-view", "--zoom",      "--background",
                           "--exposure",      "--seed",      "--output",
                           "--server",        "--deadline",  "--quiet",
                           "--verbose",       "Examples:",   "latitude-longitude"}) {
    EXPECT_THAT(render.out, HasSubstr(word));
  }
  const auto lobe = shell("gonio lobe --help");
  EXPECT_EQ(lobe.exit_code, 0);
  for (const char* word : {"--material", "--theta", "--phi", "--scale", "--cosine", "--size",
                           "--output", "--server"}) {
    EXPECT_THAT(lobe.out, HasSubstr(word));
  }
}

TEST_F(Picture, PngIsTheExrExposed) {
  const auto png = shell(kRender + kSmall + "--light sky --exposure -1 -o " + path("a.png"));
  EXPECT_EQ(png.exit_code, 0) << png.err;
  EXPECT_THAT(png.err, IsEmpty());
  const auto exr = shell(kRender + kSmall + "--light sky --exposure -1 -o " + path("a.exr"));
  EXPECT_EQ(exr.exit_code, 0) << exr.err;
  EXPECT_EQ(listing(), "a.exr\na.png\n");
  auto linear = image::read(path("a.exr"));
  ASSERT_TRUE(linear.ok()) << linear.error().message;
  EXPECT_EQ(linear->width, 40);
  EXPECT_EQ(linear->height, 30);
  EXPECT_EQ(decoded_png(read_file(path("a.png"))).rgb, image::srgb_bytes(*linear, -1));
}

TEST_F(Picture, DependsOnTheSeedAndNotOnThreads) {
  const std::string command = kRender + kSmall + "--light sky --shape cylinder ";
  for (const char* variant : {"a.exr --threads 1", "b.exr --threads 3", "c.exr --seed 1"}) {
    EXPECT_EQ(shell(command + "-o " + path(variant)).exit_code, 0);
  }
  EXPECT_EQ(read_file(path("a.exr")), read_file(path("b.exr")));
  EXPECT_NE(read_file(path("a.exr")), read_file(path("c.exr")));
}

TEST_F(Picture, ServersPictureIsTheSame) {
  const SocketServer server;
  for (const std::string& command : {kRender + kSmall, kLobe + "--theta 30 --size 200x200 "}) {
    EXPECT_EQ(shell(command + "-o " + path("a.png")).exit_code, 0);
    const auto remote = shell(command + "-o " + path("b.png") + " --server " + server.address());
    EXPECT_EQ(remote.exit_code, 0) << remote.err;
    EXPECT_EQ(read_file(path("a.png")), read_file(path("b.png")));
  }
}

// The middle of the picture reflects the light's direction given in either way.
TEST_F(Picture, LightsDirectionByVectorOrAngles) {
  EXPECT_EQ(shell(kRender + kSmall + "--light-direction=0,-3,3 -o " + path("a.exr")).exit_code, 0);
  EXPECT_EQ(
      shell(kRender + kSmall + "--light-theta 45 --light-phi -90 -o " + path("b.exr")).exit_code,
      0);
  auto a = image::read(path("a.exr")), b = image::read(path("b.exr"));
  ASSERT_TRUE(a.ok() && b.ok());
  for (std::size_t i = 0; i < a->pixels.size(); ++i) {
    EXPECT_NEAR(a->pixels[i][0], b->pixels[i][0], 1e-3 * (1 + a->pixels[i][0]));
  }
}

TEST_F(Picture, MapsLightAndShow) {
  store(path("map.pfm"), pfm_of(map()));
  auto exr = image::encode_exr(map());
  ASSERT_TRUE(exr.ok());
  store(path("map.exr"), *exr);
  for (const char* file : {"map.pfm", "map.exr"}) {
    const auto result = shell(kRender + kSmall + "--light " + path(file) + " -o " +
                              path(std::string(file) + ".exr"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  EXPECT_EQ(read_file(path("map.pfm.exr")), read_file(path("map.exr.exr")));
  auto picture = image::read(path("map.exr.exr"));
  ASSERT_TRUE(picture.ok());
  // Its lower left corner looks down and ahead, to the left of the middle: row 2, column 3.
  EXPECT_TRUE((picture->at(0, 29) == map().at(3, 2)).all()) << picture->at(0, 29);
}

TEST_F(Picture, MapsThatAreNoLightAreRefused) {
  Image bad = map();
  bad.at(5, 1)[2] = std::numeric_limits<float>::quiet_NaN();
  store(path("nan.pfm"), pfm_of(bad));
  auto exr = image::encode_exr(map());
  ASSERT_TRUE(exr.ok());
  store(path("half.exr"), exr->substr(0, exr->size() / 2));
  store(path("half.pfm"), pfm_of(map()).substr(0, 200));
  const auto light = [&](const std::string& file) {
    return kRender + kSmall + "--light " + file + " -o " + path("out.png");
  };
  expect_refused(light(path("nan.pfm")), {"nan.pfm", "blue", "column 5, row 1", "finite"});
  expect_refused(light(path("half.exr")), {"half.exr"});
  expect_refused(light(path("half.pfm")), {"half.pfm", "truncated"});
  expect_refused(light(path("none.exr")), {"none.exr"});
  expect_refused(light("moon"), {"--light", "moon", "directional, sky"});
}

TEST_F(Picture, WrongNumbersAreRefused) {
  const std::string out = " -o " + path("out.png");
  const std::string sizes = "WIDTHxHEIGHT, each from 1 to 8192";
  for (const char* size : {"0x10", "10", "10x", "-5x5", "8193x1", "1e3x10", "10x10x10"}) {
    expect_refused(kRender + "--size " + size + out, {"--size", size, sizes});
  }
  for (const char* count : {"0", "65537", "1e12", "nan"}) {
    expect_refused(kRender + "--spp " + count + out, {"--spp", "1 to 65536"});
  }
  expect_refused(kRender + "--spp 1.5" + out, {"--spp is 1.5", "whole"});
  expect_refused(kRender + "--view-elevation 91" + out, {"--view-elevation is 91", "-90 to 90"});
  expect_refused(kRender + "--field-of-view 121" + out, {"--field-of-view", "0 to 120"});
  expect_refused(kRender + "--zoom 0" + out, {"--zoom", "0.1 to 1000"});
  expect_refused(kRender + "--exposure nan" + out, {"--exposure", "-32 to 32"});
  expect_refused(kRender + "--background -1" + out, {"--background", "0 to"});
  expect_refused(kRender + "--light-theta 181" + out, {"--light-theta", "0 to 180"});
  for (const char* direction : {"0,0,0", "1,2", "1,2,3,4", "1,,2", "nan,0,1", "inf,0,1"}) {
    expect_refused(kRender + "--light-direction=" + direction + out,
                   {"--light-direction", direction, "X,Y,Z"});
  }
  expect_refused(kRender + "--light sky --light-theta 3" + out, {"--light", "directional"});
  expect_refused(kRender + "--seed -1" + out, {"--seed"});
  expect_refused(kRender + "--shape cube" + out, {"--shape"});
}

TEST_F(Picture, WrongAnglesOfLobesAreRefused) {
  const std::string out = " -o " + path("out.png");
  for (const char* theta : {"90", "-1", "30,95", "nan", "1,2,3,4,5,6,7,8,9"}) {
    expect_refused(kLobe + "--theta " + theta + out, {"--theta"});
  }
  expect_refused(kLobe + "--theta 30 --phi 400" + out, {"--phi is 400", "-360 to 360"});
  expect_refused(kLobe + "--theta 30 --scale sqrt" + out, {"--scale"});
  expect_refused(kLobe + "--theta 30 --size 99x400" + out, {"--size", "100 to 8192"});
  expect_refused(kLobe + "--theta 30 -o " + path("out.exr"), {"-o", ".png"});
}

TEST_F(Picture, WrongMaterialsLeaveTheOldPicture) {
  write_file(path("old.png"), "old");
  const std::string spectrum =
      R"( --material '{"model": "lambertian", "parameters": {"rd": [0.1, 0.2, 0.3, 0.4]}}' -o )" +
      path("old.png");
  const std::string unknown = R"( --material '{"model": "x"}' -o )" + path("old.png");
  for (const std::string command : {"gonio render", "gonio lobe --theta 30"}) {
    expect_refused(command + spectrum, {"--material is of 4 channels", "1 channel"});
    expect_refused(command + unknown, {"\"x\""});
  }
  EXPECT_EQ(read_file(path("old.png")), "old");
}

TEST_F(Picture, WhatCannotBeWrittenIsSaidBeforeTheWork) {
  for (const std::string& command :
       {kRender + "--size 8192x8192 --spp 65536 ", kLobe + "--theta 30 "}) {
    expect_refused(command + "-o " + path("nowhere/a.png"), {"nowhere/a.png", "No such file"}, 1);
    expect_refused(command + "-o " + path("a.jpg"), {"a.jpg", ".png"});
  }
  expect_refused(kRender + kSmall + "--server 127.0.0.1:1 -o " + path("a.png"), {"127.0.0.1:1"}, 3);
}

TEST_F(Picture, InterruptLeavesNothingBehind) {
  std::filesystem::create_directory(path("out"));
  const auto result =
      shell(GONIO_PROGRAM " render" + kMaterial + "--size 4000x4000 --spp 4096 -o " +
            path("out/a.png") + " & pid=$!; until [ -n \"$(ls -A " + path("out") +
            ")\" ]; do sleep 0.05; done; "
            "kill -TERM $pid; wait $pid; echo $?; ls -A " +
            path("out"));
  EXPECT_EQ(result.out, "143\n") << result.err;
}

TEST_F(Picture, LobeHasItsSize) {
  const auto result = shell(kLobe + "--theta 10,70 --scale cbrt --cosine -o " + path("a.png"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(decoded_png(read_file(path("a.png"))).width, 2 * 390 + 120);
  EXPECT_EQ(shell(kLobe + "--theta 10 --size 300x123 -o " + path("b.png")).exit_code, 0);
  const Png small = decoded_png(read_file(path("b.png")));
  EXPECT_EQ(small.width, 300);
  EXPECT_EQ(small.height, 123);
}

TEST_F(Picture, VerboseReports) {
  const auto result = shell(kRender + kSmall + "-v -o " + path("a.png"));
  EXPECT_THAT(result.err, AllOf(StartsWith("gonio: "), HasSubstr("pairs x 3 channels in")));
}

}  // namespace
}  // namespace gonio::test
