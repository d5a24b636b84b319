// Fits over the wire: the library's own result, progress, errors.
#include "fit/fit.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "client/messages/fit_convert.h"
#include "client/support/fit_fixture.h"
#include "effort.h"
#include "gonio/engine/evaluate.h"
#include "measured/synthetic_merl.h"
#include "server/messages/fit_messages.h"
#include "wire/mapping/certificate.h"

namespace gonio::test {
namespace {

using ::testing::Contains;
using Clock = std::chrono::steady_clock;

using Fit = FitFixture;

TEST_F(Fit, IsTheLibrarysOwnOnEveryTransport) {
  const Measured measured(4000);
  const auto wide = [](const auto& x) { return std::vector<double>(x.begin(), x.end()); };
  const auto data = fit::from_pairs(wide(measured.wi), wide(measured.wo), wide(measured.values), 3,
                                    wide(measured.weights));
  ASSERT_TRUE(data.ok());
  const auto own = fit::fit(*data, gonio::testing::form_of(kTruth), {});
  ASSERT_TRUE(own.ok());
  auto expected = server::to_wire(*own);
  const auto forget_time = [](v1::FitCertificate& certificate) {
    certificate.clear_cpu_seconds();
    for (auto& stage : *certificate.mutable_stages()) stage.clear_cpu_seconds();
  };
  forget_time(*expected.mutable_certificate());
  for (const char* transport : {"tcp", "unix", "in-process"}) {
    const auto result = connect(transport).fit(measured.data(), form());
    ASSERT_TRUE(result.ok()) << result.error().message;
    v1::FitResult answer;
    ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(result->json, &answer).ok());
    forget_time(*answer.mutable_certificate());
    EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(answer, expected)) << transport;
    // The caller has all of it.
    EXPECT_EQ(result->certificate.objective, client::Objective::l1);
    auto certificate = wire::to_message(result->certificate);
    forget_time(certificate);
    EXPECT_TRUE(
        google::protobuf::util::MessageDifferencer::Equals(certificate, expected.certificate()))
        << transport;
    // What comes back is a material like any other.
    EXPECT_EQ(*connect(transport).channels(result->material), 3);
  }
}

// On average: that a busy machine lets a message wait says nothing of the server.
TEST_F(Fit, SpeaksAtLeastTwiceASecond) {
  const Measured measured(100'000 / gonio::testing::kSlower);
  client::FitOptions options;
  options.polish = true;
  options.starts = 100;
  options.scan_pairs = 100'000;  // descents for some seconds
  std::vector<std::string> stages;
  client::FitWatch watch;
  watch.progress = [&](const client::FitProgress& progress) { stages.push_back(progress.stage); };
  const auto start = Clock::now();
  const auto result = connect("tcp").fit(measured.data(), form(), options, watch);
  ASSERT_TRUE(result.ok()) << result.error().message;
  const std::chrono::duration<double> took = Clock::now() - start;
  EXPECT_GT(static_cast<double>(stages.size()), 2 * took.count());
  EXPECT_THAT(stages, Contains("starts"));
}

TEST_F(Fit, NamesWhatIsWrong) {
  const Measured measured(50);
  const auto client = connect("tcp");
  const auto error_of = [&](const client::FitData& data, const client::Material& what,
                            const client::FitOptions& options = {}) {
    const auto result = client.fit(data, what, options);
    return result ? Error{} : result.error();
  };
  const auto ggx_with = [](const client::Parameters& parameters) {
    return client::Material::sum(std::nullopt, {client::Lobe{"ggx", parameters}});
  };
  EXPECT_EQ(error_of(measured.data(), ggx_with({{"alpha_x", 7.0}})).field,
            "form.specular[0].parameters.alpha_x");
  EXPECT_EQ(error_of(measured.data(), client::Material::named("gold")).field, "form");
  EXPECT_EQ(error_of(measured.data(), client::Material::model("nothing")).field, "form.model");
  client::FitOptions options;
  options.max_theta = 2;
  EXPECT_EQ(error_of(measured.data(), form(), options).field, "options.max_theta");
  client::FitData data = measured.data();
  data.channels = 2;
  EXPECT_EQ(error_of(data, form()).field, "pairs.values");
  data.channels = 65;
  EXPECT_EQ(error_of(data, form()).field, "pairs.channels");
  EXPECT_EQ(error_of(measured.data(), ggx_with({{"f0", std::vector<double>(100'000, 0.5)}})).field,
            "material");  // refused before it is parsed
  data = {};
  data.measured = client::Material::named("nickel");
  EXPECT_EQ(error_of(data, form()).field, "measured.name");
  EXPECT_EQ(error_of(data, form()).code, ErrorCode::not_found);
  data.measured = ggx();
  EXPECT_EQ(error_of(data, form()).field, "measured");
}

// The server holds the file; only its name travels.
TEST_F(Fit, TakesAMeasuredMaterialOfTheServers) {
  const auto grey = [](double theta_h, double, double) {
    const double f = theta_h < 1 ? 0.1 : -1;
    return gonio::testing::Rgb{f, f / 2, f / 4};
  };
  ASSERT_TRUE(gonio::testing::write_merl(folder_ / "grey.binary", grey));
  start_with([&](server::ServerOptions& options) { options.materials = folder_ / ""; });
  client::FitData data;
  data.measured = client::Material::named("grey");
  const auto result = connect("tcp").fit(data, client::Material::model("lambertian"));
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_GT(result->certificate.left_out.negative, 0U);
  EXPECT_NEAR(result->certificate.parameters.at(0).value, 0.1 * std::numbers::pi, 1e-3);
  EXPECT_LT(result->certificate.errors.all.l1, 1e-3);
}

TEST_F(Fit, OfNothingFailsWithTheReason) {
  const std::vector<float> up{0, 0, 1}, value{std::nanf("")};
  const auto result = connect("tcp").fit({up, up, value, 1, {}, {}}, form());
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_EQ(result->certificate.verdict, client::Verdict::failed);
  EXPECT_EQ(result->certificate.left_out.not_finite, 1U);
  EXPECT_FALSE(result->certificate.reason.empty());
}

}  // namespace
}  // namespace gonio::test
