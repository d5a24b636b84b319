// The client's put_material, and what is then done with the material by its name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <numbers>
#include <thread>

#include "client/support/fit_fixture.h"
#include "measured/synthetic_merl.h"

namespace gonio::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string& content() {
  static const std::string kContent = [] {
    const gonio::testing::TempFolder folder;
    const auto grey = [](double, double, double) { return gonio::testing::Rgb{0.1, 0.05, 0.025}; };
    EXPECT_TRUE(gonio::testing::write_merl(folder / "grey.binary", grey));
    std::ifstream in(folder / "grey.binary", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  return kContent;
}

using Put = FitFixture;

TEST_F(Put, IsThenEvaluatedAndFittedByName) {
  const auto client = connect("tcp");
  double sent = 0;
  client::PutWatch watch;
  watch.progress = [&](double part) {
    EXPECT_GE(part, sent);
    sent = part;
  };
  const auto report = client.put_material("grey", content(), watch);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(sent, 1);
  EXPECT_EQ(report->place, client::PutPlace::memory);
  EXPECT_EQ(report->cells, 1'458'000U);
  EXPECT_EQ(report->invalid_cells, 0U);
  EXPECT_EQ(report->sha256.size(), 64U);
  EXPECT_THAT(client.list_models()->materials, Contains("grey"));

  std::vector<float> up{0, 0, 1}, values(3);
  ASSERT_TRUE(client.evaluate(client::Material::named("grey"), up, up, values).ok());
  EXPECT_FLOAT_EQ(values[0], 0.1F);
  client::FitData data;
  data.measured = client::Material::named("grey");
  const auto fit = client.fit(data, client::Material::model("lambertian"));
  ASSERT_TRUE(fit.ok()) << fit.error().message;
  EXPECT_NEAR(fit->certificate.parameters.at(0).value, 0.1 * std::numbers::pi, 1e-4);

  // In a second client and over another transport: nothing is sent twice for nothing.
  const auto again = connect("unix").put_material("grey", content());
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_TRUE(again->existed);
}

TEST_F(Put, NamesWhatIsWrong) {
  const auto client = connect("tcp");
  const auto error_of = [&](const std::string& name, std::string_view bytes) {
    const auto report = client.put_material(name, bytes);
    EXPECT_FALSE(report.ok());
    return report ? Error{} : report.error();
  };
  EXPECT_EQ(error_of("../grey", content()).field, "file.name");
  EXPECT_EQ(error_of("grey", "").field, "file.size");
  EXPECT_EQ(error_of("grey", content() + "x").code, ErrorCode::resource_exhausted);
  std::string other = content();
  other[4] = 1;
  EXPECT_THAT(error_of("grey", other).message, HasSubstr("dimensions 90 1 180"));
  EXPECT_THAT(client.list_models()->materials, Not(Contains("grey")));
}

TEST_F(Put, CanBeStoppedAndLate) {
  const auto client = connect("unix");
  client::PutWatch watch;
  double sent = 0;
  watch.progress = [&](double part) { sent = part; };
  watch.stop = [&] { return sent > 0.3; };
  auto report = client.put_material("grey", content(), watch);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::cancelled);
  watch = {};
  watch.deadline = std::chrono::milliseconds(1);
  report = client.put_material("grey", content(), watch);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::deadline_exceeded) << report.error().message;
  EXPECT_THAT(client.list_models()->materials, Not(Contains("grey")));
}

// Several of one name at a time: one is stored, and the same bytes are no conflict.
TEST_F(Put, TwoAtATimeAgree) {
  const auto client = connect("tcp");
  std::vector<std::thread> threads;
  std::atomic<int> stored{0};
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      const auto report = client.put_material("grey", content());
      EXPECT_TRUE(report.ok()) << report.error().message;
      if (report.ok() && !report->existed) ++stored;
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(stored, 1);
}

}  // namespace
}  // namespace gonio::test
