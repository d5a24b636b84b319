// The compute pool: every tile once, fair, bounded, stoppable, and finished before it is gone.
#include "gonio/engine/thread_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <latch>
#include <thread>
#include <vector>

namespace gonio {
namespace {

using Counts = std::vector<std::atomic<int>>;

bool all_are(const Counts& counts, int n) {
  return std::all_of(counts.begin(), counts.end(), [n](const auto& c) { return c.load() == n; });
}

TEST(ThreadPool, RunsEveryTileOnceAndSaysSo) {
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads, 4);
    EXPECT_EQ(pool.threads(), threads);
    for (const std::size_t tiles : {0, 1, 2, 3, 100, 5000}) {
      Counts counts(tiles);
      std::promise<bool> done;
      ASSERT_TRUE(pool.submit({tiles,
                               [&](std::size_t t) { ++counts[t]; },
                               {},
                               [&](bool completed) { done.set_value(completed); }}));
      EXPECT_TRUE(done.get_future().get());
      EXPECT_TRUE(all_are(counts, 1)) << threads << " threads, " << tiles << " tiles";
    }
  }
}

TEST(ThreadPool, RunReturnsWhenAllTilesAreDone) {
  for (const int threads : {1, 3}) {
    ThreadPool pool(threads, 1);
    for (const std::size_t tiles : {0, 1, 2, 7, 1000}) {
      Counts counts(tiles);
      pool.run(tiles, [&](std::size_t t) { ++counts[t]; });
      EXPECT_TRUE(all_are(counts, 1)) << threads << " threads, " << tiles << " tiles";
    }
  }
}

TEST(ThreadPool, BriefRunsAreDoneWhetherSharedOrNot) {
  ThreadPool pool(2, 1);
  std::atomic<int> sum{0};
  for (int i = 0; i < 20000; ++i) {
    if (i % 5000 == 4999) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // all asleep
    pool.run(
        3, [&](std::size_t t) { sum += static_cast<int>(t) + 1; }, true);
    ASSERT_EQ(sum.load(), 6 * (i + 1));
  }
}

// Holds the pool's only thread until it is let go.
class Blocker {
 public:
  explicit Blocker(ThreadPool& pool) {
    EXPECT_TRUE(pool.submit({1,
                             [this](std::size_t) {
                               started_.count_down();
                               go_.wait();
                             },
                             {},
                             {}}));
    started_.wait();
  }
  void release() { go_.count_down(); }

 private:
  std::latch started_{1}, go_{1};
};

TEST(ThreadPool, RefusesJobsBeyondItsBoundAndLeavesThemUntouched) {
  ThreadPool pool(1, 2);
  Blocker blocker(pool);
  std::promise<void> second;
  ASSERT_TRUE(pool.submit({1, [](std::size_t) {}, {}, [&](bool) { second.set_value(); }}));
  EXPECT_EQ(pool.jobs(), 2U);
  bool called = false;
  ThreadPool::Job job{3, [&](std::size_t) { called = true; }, {}, [&](bool) { called = true; }};
  EXPECT_FALSE(pool.submit(std::move(job)));
  EXPECT_EQ(job.tiles, 3U);  // NOLINT(bugprone-use-after-move): a refused job is promised back
  ASSERT_TRUE(job.run && job.done);
  EXPECT_FALSE(called);
  // run() is never refused: the calling thread does the work if nobody else can.
  Counts counts(10);
  pool.run(10, [&](std::size_t t) { ++counts[t]; });
  EXPECT_TRUE(all_are(counts, 1));
  blocker.release();
  second.get_future().wait();
  while (pool.jobs() > 0) std::this_thread::yield();
  std::promise<void> third;
  EXPECT_TRUE(pool.submit({1, [](std::size_t) {}, {}, [&](bool) { third.set_value(); }}));
  third.get_future().wait();
}

TEST(ThreadPool, TakesJobsInTurn) {
  ThreadPool pool(1, 4);
  Blocker blocker(pool);
  std::vector<char> order;  // touched by the pool's one thread only, then after both are done
  std::promise<void> long_done, short_done;
  ASSERT_TRUE(pool.submit(
      {50, [&](std::size_t) { order.push_back('l'); }, {}, [&](bool) { long_done.set_value(); }}));
  ASSERT_TRUE(pool.submit(
      {2, [&](std::size_t) { order.push_back('s'); }, {}, [&](bool) { short_done.set_value(); }}));
  blocker.release();
  short_done.get_future().wait();
  long_done.get_future().wait();
  ASSERT_EQ(order.size(), 52U);
  const auto last_short = std::find(order.rbegin(), order.rend(), 's').base() - order.begin();
  EXPECT_LE(last_short, 5);
}

TEST(ThreadPool, StopsBetweenTiles) {
  for (const int threads : {1, 4}) {
    ThreadPool pool(threads, 2);
    std::atomic<int> ran = 0;
    std::promise<bool> done;
    ASSERT_TRUE(pool.submit({100000, [&](std::size_t) { ++ran; }, [&] { return ran >= 10; },
                             [&](bool completed) { done.set_value(completed); }}));
    EXPECT_FALSE(done.get_future().get());
    EXPECT_GE(ran, 10);
    EXPECT_LT(ran, 10 + threads + 1);  // those that had asked before the tenth ended
    // Others are not touched.
    Counts counts(50);
    pool.run(50, [&](std::size_t t) { ++counts[t]; });
    EXPECT_TRUE(all_are(counts, 1));
  }
}

TEST(ThreadPool, StopsWhatHasNotBegun) {
  ThreadPool pool(1, 2);
  Blocker blocker(pool);
  bool ran = false;
  std::promise<bool> done;
  ASSERT_TRUE(pool.submit({5, [&](std::size_t) { ran = true; }, [] { return true; },
                           [&](bool completed) { done.set_value(completed); }}));
  blocker.release();
  EXPECT_FALSE(done.get_future().get());
  EXPECT_FALSE(ran);
}

TEST(ThreadPool, FinishesQueuedJobsBeforeItIsGone) {
  for (int round = 0; round < 20; ++round) {
    Counts counts(200);
    std::atomic<int> done = 0;
    {
      ThreadPool pool(2, 10);
      for (std::size_t job = 0; job < 10; ++job) {
        ASSERT_TRUE(pool.submit({20,
                                 [&, job](std::size_t t) { ++counts[job * 20 + t]; },
                                 {},
                                 [&](bool completed) { done += completed ? 1 : 0; }}));
      }
    }
    ASSERT_EQ(done, 10);
    ASSERT_TRUE(all_are(counts, 1));
  }
}

TEST(ThreadPool, AcceptsTheNextJobFromDone) {
  ThreadPool pool(2, 1);
  std::atomic<int> left = 100;
  std::promise<void> finished;
  std::function<void(bool)> next = [&](bool) {
    if (--left == 0) return finished.set_value();
    if (pool.submit({3, [](std::size_t) {}, {}, next})) return;
    ADD_FAILURE() << "refused with " << left << " left";
    finished.set_value();
  };
  ASSERT_TRUE(pool.submit({3, [](std::size_t) {}, {}, next}));
  ASSERT_EQ(finished.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(ThreadPool, ServesManyCallersAtOnce) {
  constexpr int kCallers = 8, kRounds = 100;
  ThreadPool pool(3, kCallers);
  std::atomic<int> wrong = 0, refused = 0;
  std::vector<std::thread> callers;
  for (int caller = 0; caller < kCallers; ++caller) {
    callers.emplace_back([&, caller] {
      for (int round = 0; round < kRounds; ++round) {
        const auto tiles = static_cast<std::size_t>((caller * 7 + round) % 23);
        Counts counts(tiles);
        if (round % 2 == 0) {
          pool.run(tiles, [&](std::size_t t) { ++counts[t]; });
        } else {
          std::promise<bool> done;
          if (!pool.submit({tiles,
                            [&](std::size_t t) { ++counts[t]; },
                            {},
                            [&](bool completed) { done.set_value(completed); }})) {
            ++refused;
            continue;
          }
          if (!done.get_future().get()) ++wrong;
        }
        if (!all_are(counts, 1)) ++wrong;
      }
    });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(refused, 0);
  while (pool.jobs() > 0) std::this_thread::yield();
}

}  // namespace
}  // namespace gonio
