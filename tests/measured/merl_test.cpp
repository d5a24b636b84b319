// The reader of MERL files: what a good one gives, and what is said of each kind of bad one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>

#include "gonio/measured/table.h"
#include "measured/npf_material.h"
#include "measured/synthetic_merl.h"
#include "measured/temp_folder.h"

namespace gonio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::IsotropicFunction;
using testing::kMerlBytes;
using testing::kMerlCells;
using testing::NpfMaterial;
using testing::Rgb;
using testing::TempFolder;

class MerlReader : public ::testing::Test {
 protected:
  // A well-formed file that is 0 everywhere; costs no disk space.
  std::filesystem::path black_file(std::array<std::int32_t, 3> dimensions = {90, 90, 180}) const {
    const auto file = folder_ / "black.binary";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(dimensions.data()), sizeof dimensions);
    std::filesystem::resize_file(file, kMerlBytes);
    return file;
  }

  static void poke(const std::filesystem::path& file, std::size_t channel, std::size_t cell,
                   double value) {
    std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
    out.seekp(static_cast<std::streamoff>(12 + 8 * (channel * kMerlCells + cell)));
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
  }

  // Expects an error that names the file, what was found and what was expected.
  static void expect_error(const std::filesystem::path& file, ErrorCode code,
                           const std::string& found, const std::string& expected) {
    const auto table = MeasuredTable::read_merl(file);
    ASSERT_FALSE(table.ok());
    EXPECT_EQ(table.error().code, code);
    EXPECT_THAT(table.error().message,
                AllOf(HasSubstr(file.string()), HasSubstr(found), HasSubstr(expected)));
    EXPECT_THAT(table.error().value, HasSubstr(found));
    EXPECT_THAT(table.error().allowed, HasSubstr(expected));
  }

  TempFolder folder_;
};

void expect_holds(const MeasuredTable& table, const IsotropicFunction& f) {
  std::size_t invalid = 0;
  double worst = 0;
  for (std::size_t cell = 0; cell < kMerlCells; ++cell) {
    const Rgb want = testing::at_cell_centre(f, cell);
    const bool valid = std::ranges::all_of(want, [](double v) { return v >= 0; });
    invalid += valid ? 0 : 1;
    for (std::size_t c = 0; c < 3; ++c) {
      const double got = static_cast<double>(table.data()[cell * 3 + c]);
      ASSERT_EQ(std::isnan(got), !valid) << "cell " << cell << " channel " << c;
      if (valid) worst = std::max(worst, std::abs(got - want[c]) / want[c]);
    }
  }
  EXPECT_LE(worst, 6.1e-8);  // the rounding to float32 and of the scale factors
  EXPECT_EQ(table.invalid_cells(), invalid);
}

TEST_F(MerlReader, ReadsWhatWasWritten) {
  const auto file = folder_ / "glossy.binary";
  ASSERT_TRUE(testing::write_merl(file, testing::glossy_example));
  ASSERT_EQ(std::filesystem::file_size(file), kMerlBytes);
  const auto table = MeasuredTable::read_merl(file);
  ASSERT_TRUE(table.ok()) << table.error().message;
  expect_holds(**table, testing::glossy_example);
  EXPECT_EQ((*table)->invalid_cells(), 0U);
}

TEST_F(MerlReader, ReadsRealMaterials) {
  for (const char* name : {"nickel", "beige-fabric", "aluminium"}) {
    const auto material = NpfMaterial::load(name);
    if (!material) GTEST_SKIP() << "no " << name << " in " << testing::data_folder() / "merl";
    const auto file = folder_ / "real.binary";
    ASSERT_TRUE(testing::write_merl(file, *material));
    const auto table = MeasuredTable::read_merl(file);
    ASSERT_TRUE(table.ok()) << table.error().message;
    expect_holds(**table, *material);
    EXPECT_GT((*table)->invalid_cells(), 0U);
  }
}

TEST_F(MerlReader, TakesACellWithoutOneChannelAsNotMeasured) {
  const auto file = black_file();
  poke(file, 0, 100, 3.0);
  poke(file, 1, 100, -1.0);
  poke(file, 2, kMerlCells - 1, -1e-300);
  poke(file, 2, 7, -0.0);
  const auto table = MeasuredTable::read_merl(file);
  ASSERT_TRUE(table.ok()) << table.error().message;
  EXPECT_EQ((*table)->invalid_cells(), 2U);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_TRUE(std::isnan((*table)->data()[300 + c]));
    EXPECT_TRUE(std::isnan((*table)->data()[3 * kMerlCells - 3 + c]));
    EXPECT_FALSE(std::signbit((*table)->data()[21 + c]));
  }
}

TEST_F(MerlReader, SaysThatThereIsNoFile) {
  expect_error(folder_ / "none.binary", ErrorCode::not_found, "no such file", "MERL");
  expect_error(folder_ / "none" / "x.binary", ErrorCode::not_found, "no such file", "MERL");
}

TEST_F(MerlReader, SaysThatItIsAFolder) {
  expect_error(folder_ / "", ErrorCode::invalid_argument, "a folder", "MERL");
}

TEST_F(MerlReader, DoesNotWaitForAPipe) {
  const auto pipe = folder_ / "pipe.binary";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect_error(pipe, ErrorCode::invalid_argument, "a pipe", "MERL");
}

TEST_F(MerlReader, SaysWhichDimensionsItFound) {
  expect_error(black_file({90, 90, 360}), ErrorCode::data_loss, "90 90 360", "90 90 180");
  expect_error(black_file({90, 180, 90}), ErrorCode::data_loss, "90 180 90", "90 90 180");
  expect_error(black_file({-1, 0, 180}), ErrorCode::data_loss, "-1 0 180", "90 90 180");
}

TEST_F(MerlReader, SaysHowMuchIsMissing) {
  const auto file = black_file();
  for (const std::uintmax_t bytes : {kMerlBytes - 1, kMerlBytes / 2, std::uintmax_t{12},
                                     std::uintmax_t{11}, std::uintmax_t{0}}) {
    std::filesystem::resize_file(file, bytes);
    expect_error(file, ErrorCode::data_loss,
                 std::to_string(bytes) + " bytes (truncated: " + std::to_string(kMerlBytes - bytes),
                 std::to_string(kMerlBytes) + " bytes");
  }
}

TEST_F(MerlReader, SaysHowMuchIsTooMuch) {
  for (const std::uintmax_t extra : {1, 8, 1 << 20}) {
    const auto file = black_file();
    std::filesystem::resize_file(file, kMerlBytes + extra);
    expect_error(file, ErrorCode::data_loss, "too long by " + std::to_string(extra),
                 std::to_string(kMerlBytes) + " bytes");
  }
}

TEST_F(MerlReader, SaysWhichCellIsNotFinite) {
  constexpr std::size_t kCell = (12 * 90 + 34) * 180 + 56;
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [value, text] : {std::pair{std::nan(""), "nan"}, std::pair{infinity, "inf"},
                                    std::pair{-infinity, "-inf"}, std::pair{1e300, "1000"}}) {
    const auto file = black_file();
    poke(file, 2, kCell, value);
    expect_error(file, ErrorCode::data_loss, text, "finite");
    expect_error(file, ErrorCode::data_loss, "[theta_h 12][theta_d 34][phi_d 56] of B", "finite");
  }
}

// The most memory that this process held since the last reset, in bytes; 0 if it cannot be told.
std::size_t peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

TEST_F(MerlReader, CostsNoMoreMemoryThanTheTable) {
#ifdef GONIO_SANITIZED
  GTEST_SKIP() << "sanitizers keep memory of their own";
#endif
  const auto file = black_file();
  ::malloc_trim(0);  // what earlier tests freed would hide what this one takes
  if (!(std::ofstream("/proc/self/clear_refs") << 5).flush()) GTEST_SKIP() << "no /proc";
  const std::size_t before = peak_memory();
  if (before == 0) GTEST_SKIP() << "no /proc";
  const auto table = MeasuredTable::read_merl(file);
  ASSERT_TRUE(table.ok());
  const std::size_t table_bytes = kMerlCells * 3 * sizeof(float);
  EXPECT_GE(peak_memory() - before, table_bytes / 2);  // or the check could not fail
  EXPECT_LE(peak_memory() - before, table_bytes + (std::size_t{2} << 20));
}

TEST(MeasuredTableFromValues, KeepsThemAndCountsInvalidCells) {
  std::vector<float> values(kMerlCells * 3, 0.25F);
  values[3 * 5 + 1] = std::numeric_limits<float>::quiet_NaN();
  values[3 * 9] = -1;
  const auto table = MeasuredTable::from_values(values);
  ASSERT_TRUE(table.ok());
  EXPECT_EQ((*table)->invalid_cells(), 2U);
  EXPECT_TRUE(std::isnan((*table)->data()[3 * 5 + 2]));
  EXPECT_TRUE(std::isnan((*table)->data()[3 * 9 + 1]));
  EXPECT_EQ((*table)->data()[0], 0.25F);
}

TEST(MeasuredTableFromValues, RefusesWrongLengthsAndInfinities) {
  std::vector<float> values(kMerlCells * 3 - 1);
  const auto shorter = MeasuredTable::from_values(values);
  ASSERT_FALSE(shorter.ok());
  EXPECT_THAT(shorter.error().message, AllOf(HasSubstr("4373999"), HasSubstr("4374000")));
  values.resize(kMerlCells * 3);
  values[3 * 181 + 1] = std::numeric_limits<float>::infinity();
  const auto infinite = MeasuredTable::from_values(values);
  ASSERT_FALSE(infinite.ok());
  EXPECT_THAT(infinite.error().message, HasSubstr("[theta_h 0][theta_d 1][phi_d 1] of G"));
}

}  // namespace
}  // namespace gonio
