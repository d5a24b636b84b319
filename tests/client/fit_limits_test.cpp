// Fits over the wire: cancelling, deadlines, the queue, evaluation beside them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

#include "client/messages/fit_convert.h"
#include "client/support/fit_fixture.h"
#include "effort.h"

namespace gonio::test {
namespace {

using ::testing::HasSubstr;
using Clock = std::chrono::steady_clock;
using gonio::testing::kSlower;
using gonio::testing::WorkClock;
using std::chrono::milliseconds;
using std::chrono::seconds;
using FitLimits = FitFixture;

// Fits on a thread of its own, one after another, until it is stopped.
class LongFit {
 public:
  LongFit(client::Client client, const Measured& measured)
      : client_(std::move(client)), thread_([this, &measured] { run(measured); }) {}
  ~LongFit() { end(); }
  LongFit(const LongFit&) = delete;
  LongFit& operator=(const LongFit&) = delete;

  // Waits until the server speaks of it.
  void wait_for_word() const {
    while (!heard_ && !over_) std::this_thread::sleep_for(milliseconds(5));
    EXPECT_TRUE(heard_);
  }
  void end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }

 private:
  void run(const Measured& measured) {
    client::FitOptions slow;
    slow.polish = true;
    slow.starts = 100;
    client::FitWatch watch;
    watch.progress = [this](const auto&) { heard_ = true; };
    watch.stop = [this] { return stop_.load(); };
    auto result = client_.fit(measured.data(), slow_form(), slow, watch);
    while (result.ok()) result = client_.fit(measured.data(), slow_form(), slow, watch);
    over_ = true;
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::cancelled) << result.error().message;
  }

  client::Client client_;
  std::atomic<bool> heard_{false}, stop_{false}, over_{false};
  std::thread thread_;
};

TEST_F(FitLimits, EndsSoonWhenItIsCancelled) {
  start_with([](server::ServerOptions& options) { options.fit_threads = 1; });
  const Measured measured(200'000 / kSlower);
  client::FitOptions options;
  options.polish = true;
  for (const char* at : {"data", "scan", "starts", "fit", "polish"}) {
    bool stop = false;
    client::FitWatch watch;
    watch.progress = [&](const client::FitProgress& progress) {
      stop = stop || progress.stage == at;
    };
    WorkClock::time_point said;
    watch.stop = [&] {
      if (stop && said == WorkClock::time_point()) said = WorkClock::now();
      return stop;
    };
    const auto result = connect("unix").fit(measured.data(), form(), options, watch);
    if (!stop) continue;  // a stage of less than a moment
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::cancelled) << result.error().message;
    EXPECT_LT(WorkClock::now() - said, kSlower * milliseconds(200)) << at;
    // The only thread is free again, and what it had begun is not done first.
    const Measured little(50);
    const auto start = WorkClock::now();
    EXPECT_TRUE(connect("unix").fit(little.data(), client::Material::model("lambertian")).ok());
    EXPECT_LT(WorkClock::now() - start, kSlower * milliseconds(500)) << at;
  }
}

// The whole fit takes more than a second on two cores.
TEST_F(FitLimits, KeepsItsDeadlines) {
  const Measured measured(200'000 / kSlower);
  client::FitOptions options;
  options.polish = true;
  options.starts = 100;
  options.fit_pairs = 200'000;  // all of them
  options.deadline = milliseconds(50);
  auto start = Clock::now();
  auto result = connect("tcp").fit(measured.data(), slow_form(), options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::deadline_exceeded) << result.error().message;
  EXPECT_LT(Clock::now() - start, seconds(5));

  start_with([](server::ServerOptions& server) { server.longest_fit = milliseconds(50); });
  options.deadline.reset();
  start = Clock::now();
  result = connect("tcp").fit(measured.data(), slow_form(), options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::deadline_exceeded) << result.error().message;
  EXPECT_LT(Clock::now() - start, seconds(5));
}

TEST_F(FitLimits, IsRefusedWhereTooManyWait) {
  start_with([](server::ServerOptions& options) {
    options.fit_threads = 1;
    options.max_fits = 2;
  });
  const Measured measured(100'000 / kSlower);
  LongFit first(connect("tcp"), measured), second(connect("tcp"), measured);
  first.wait_for_word();
  second.wait_for_word();
  client::ClientOptions impatient;
  impatient.max_retries = 0;
  const auto refused = connect("tcp", impatient).fit(measured.data(), form());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
  EXPECT_THAT(refused.error().message,
              HasSubstr("queue of fits, assessments, selections and charts is full"));
  first.end();
  second.end();
  const Measured little(50);
  EXPECT_TRUE(connect("tcp").fit(little.data(), client::Material::model("lambertian")).ok());
}

// What is alone may hold more than the quota; another beside it may not.
TEST_F(FitLimits, MemoryThatIsFullIsSaidToBe) {
  start_with([](server::ServerOptions& server) {
    server.memory_quota_bytes = server.max_message_bytes = std::size_t{16} << 20;
  });
  const Measured measured(20'000 / kSlower);
  LongFit first(connect("tcp"), measured);
  first.wait_for_word();
  client::ClientOptions impatient;
  impatient.max_retries = 0;
  const Measured little(50);
  const auto refused = connect("tcp", impatient).fit(little.data(), form());
  first.end();
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
  EXPECT_THAT(refused.error().message, HasSubstr("memory is full: requests and answers hold"));
  EXPECT_THAT(refused.error().message, HasSubstr(" of 16777216 bytes, and this one needs "));
}

TEST_F(FitLimits, ARequestThatIsTooLargeSaysWhatIsAllowed) {
  start_with(
      [](server::ServerOptions& server) { server.max_message_bytes = std::size_t{1} << 20; });
  const Measured measured(40'000);
  const auto refused = connect("tcp").fit(measured.data(), form());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
  EXPECT_THAT(refused.error().message, HasSubstr("larger than max"));
  EXPECT_THAT(refused.error().allowed, HasSubstr("fewer pairs"));
}

// Before any of it is copied: the limit is a GiB.
TEST(FitData, OfMoreThanAMessageHoldsIsRefused) {
  const Measured measured(10);  // of 10 numbers each, 4 bytes
  EXPECT_TRUE(client::check_size(measured.data(), 400).ok());
  const auto refused = client::check_size(measured.data(), 399);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
  EXPECT_EQ(refused.error().value, "400 bytes");
  EXPECT_THAT(refused.error().allowed, HasSubstr("fewer pairs in one call, of at most 399 bytes"));
  client::FitData stored = measured.data();
  stored.measured = client::Material::named("nickel");
  EXPECT_TRUE(client::check_size(stored, 399).ok());
}

TEST_F(FitLimits, LeavesEvaluationAlone) {
  const Measured measured(20'000 / kSlower);
  std::atomic<int> done{0};
  const auto fit_one = [&] {
    const auto result = connect("unix").fit(measured.data(), form());
    EXPECT_TRUE(result.ok()) << result.error().message;
    ++done;
  };
  std::thread first(fit_one), second(fit_one);
  const auto client = connect("unix");
  std::vector<float> values(measured.values.size());
  int evaluations = 0;
  bool good = true;
  // Evaluations without a pause leave a busy machine nothing for fits: not without end.
  while (good && done < 2 && evaluations < 500) {
    good = client.evaluate(ggx(), measured.wi, measured.wo, values).ok();
    ++evaluations;
  }
  first.join();
  second.join();
  EXPECT_TRUE(good);
  EXPECT_GT(evaluations, 0);
}

}  // namespace
}  // namespace gonio::test
