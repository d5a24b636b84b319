// Pictures as files: PNG through libpng, OpenEXR, PFM; what is truncated, too large or of another
// kind is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "client/picture/image/exr.h"
#include "client/picture/image/pfm.h"
#include "client/picture/image/png.h"
#include "client/picture/image/read.h"
#include "client/picture/image/srgb.h"
#include "client/support/image_files.h"
#include "measured/temp_folder.h"

namespace gonio::test {
namespace {

using image::Image;
using image::Rgb;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Numbers that a smaller format would lose.
Image example() {
  Image picture(5, 3);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const auto x = static_cast<float>(i);
    picture.pixels[i] = Rgb(0.1F * x, 1e-9F * x, 123456.78F * x);
  }
  return picture;
}

class Files : public ::testing::Test {
 protected:
  std::string stored(const std::string& name, const std::string& content) {
    store(folder_ / name, content);
    return folder_ / name;
  }

  gonio::testing::TempFolder folder_;
};

TEST(Srgb, IsTheStandardsCurve) {
  // IEC 61966-2-1's two pieces, and where they meet.
  EXPECT_FLOAT_EQ(image::srgb_encoded(0.002F), 12.92F * 0.002F);
  EXPECT_NEAR(image::srgb_encoded(0.214041F), 0.5F, 1e-5F);
  EXPECT_NEAR(image::srgb_encoded(0.0031308F), image::srgb_encoded(0.0031309F), 1e-5F);
  EXPECT_FLOAT_EQ(image::srgb_encoded(7), 1);
  EXPECT_EQ(image::srgb_encoded(-1), 0);
  EXPECT_EQ(image::srgb_encoded(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Srgb, ExposureIsInStops) {
  Image picture(1, 1);
  picture.at(0, 0) = Rgb(0.21586F, 0.25F, 2.0F);
  EXPECT_THAT(image::srgb_bytes(picture, 0), ElementsAre(128, 137, 255));
  EXPECT_THAT(image::srgb_bytes(picture, 2), ElementsAre(239, 255, 255));
  EXPECT_THAT(image::srgb_bytes(picture, -1)[2], 255);
}

TEST(PngFile, ComesBackFromLibpng) {
  std::vector<std::uint8_t> rgb(3 * 7 * 4);
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>(37 * i);
  auto bytes = image::encode_png(rgb, 7, 4);
  ASSERT_TRUE(bytes.ok()) << bytes.error().message;
  const Png picture = decoded_png(*bytes);
  EXPECT_EQ(picture.width, 7);
  EXPECT_EQ(picture.height, 4);
  EXPECT_EQ(picture.rgb, rgb);
  EXPECT_THAT(*bytes, HasSubstr("sRGB"));
}

TEST_F(Files, ExrComesBackBitForBit) {
  auto bytes = image::encode_exr(example());
  ASSERT_TRUE(bytes.ok()) << bytes.error().message;
  auto again = image::read(stored("a.exr", *bytes));
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_EQ(again->width, 5);
  EXPECT_EQ(again->height, 3);
  for (std::size_t i = 0; i < again->pixels.size(); ++i) {
    EXPECT_TRUE((again->pixels[i] == example().pixels[i]).all()) << i;
  }
}

// Wherever it ends.
TEST_F(Files, TruncatedExrIsRefused) {
  auto bytes = image::encode_exr(example());
  ASSERT_TRUE(bytes.ok());
  for (std::size_t length = 0; length < bytes->size(); length += 7) {
    auto result = image::read(stored("a.exr", bytes->substr(0, length)));
    ASSERT_FALSE(result.ok()) << length;
    EXPECT_EQ(result.error().code, ErrorCode::data_loss) << result.error().message;
    EXPECT_THAT(result.error().message, HasSubstr("a.exr"));
  }
}

TEST_F(Files, PfmOfBothByteOrders) {
  const std::string little = pfm_of(example());
  auto picture = image::read(stored("a.pfm", little));
  ASSERT_TRUE(picture.ok()) << picture.error().message;
  EXPECT_TRUE((picture->at(4, 0) == example().at(4, 0)).all());
  EXPECT_TRUE((picture->at(1, 2) == example().at(1, 2)).all());

  const std::string header = "PF\n5 3\n1.0\n";
  std::string big = header + little.substr(little.size() - sizeof(Rgb) * 15);
  for (std::size_t at = header.size(); at < big.size(); at += 4) {
    std::swap(big[at], big[at + 3]);
    std::swap(big[at + 1], big[at + 2]);
  }
  auto swapped = image::read(stored("b.pfm", big));
  ASSERT_TRUE(swapped.ok()) << swapped.error().message;
  EXPECT_TRUE((swapped->at(4, 0) == example().at(4, 0)).all());
}

TEST_F(Files, GreyPfm) {
  const float row[2] = {0.5F, 4};
  const std::string bytes =
      "Pf\n2 1\n-1\n" + std::string(reinterpret_cast<const char*>(row), sizeof(row));
  auto picture = image::read(stored("g.pfm", bytes));
  ASSERT_TRUE(picture.ok()) << picture.error().message;
  EXPECT_TRUE((picture->at(1, 0) == Rgb::Constant(4)).all());
}

TEST_F(Files, BrokenPfmIsRefused) {
  const std::string whole = pfm_of(example());
  for (std::size_t length = 0; length < whole.size(); length += 5) {
    auto result = image::read(stored("a.pfm", whole.substr(0, length)));
    ASSERT_FALSE(result.ok()) << length;
    EXPECT_EQ(result.error().code, ErrorCode::data_loss) << result.error().message;
  }
  EXPECT_THAT(image::read(stored("a.pfm", whole.substr(0, whole.size() - 1))).error().message,
              HasSubstr("1 of 3 rows are missing"));
  for (const char* header : {"P6\n5 3\n255\n", "PF\n5\n", "PF\n5 3\n0\n", "PF\na b\n-1\n"}) {
    EXPECT_FALSE(image::read(stored("a.pfm", header)).ok()) << header;
  }
}

// A header may ask for more than there is memory: nothing is made before its size is checked.
TEST_F(Files, SizesBeyondTheLimitAreRefused) {
  for (const char* size : {"100000 100000", "0 5", "-3 5", "9223372036854775807 2", "33554433 1"}) {
    auto result = image::read(stored("a.pfm", "PF\n" + std::string(size) + "\n-1\n"));
    ASSERT_FALSE(result.ok()) << size;
    EXPECT_EQ(result.error().code, ErrorCode::invalid_argument) << result.error().message;
    EXPECT_THAT(result.error().message, HasSubstr("33554432"));
  }
}

TEST_F(Files, OtherFilesAreRefused) {
  EXPECT_EQ(image::read(folder_ / "none.exr").error().code, ErrorCode::not_found);
  EXPECT_THAT(image::read(stored("a.hdr", "")).error().message, HasSubstr(".exr or .pfm"));
  EXPECT_EQ(image::read(stored("a.exr", pfm_of(example()))).error().code, ErrorCode::data_loss);
}

}  // namespace
}  // namespace gonio::test
