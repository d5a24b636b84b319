// What a tile throws reaches whoever asked for it; the pool's threads go on.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <future>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <variant>

#include "gonio/engine/thread_pool.h"

namespace gonio {
namespace {

std::string words_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "no std::exception";
  }
}

// "completed", "abandoned", or what was thrown.
std::future<std::string> submit(ThreadPool& pool, std::size_t tiles,
                                std::function<void(std::size_t)> run,
                                std::function<bool()> stop = {}) {
  auto end = std::make_shared<std::promise<std::string>>();
  const auto done = [end](bool completed) {
    end->set_value(completed ? "completed" : "abandoned");
  };
  const auto failed = [end](const std::exception_ptr& failure) {
    end->set_value(words_of(failure));
  };
  EXPECT_TRUE(pool.submit({tiles, std::move(run), std::move(stop), done, failed}));
  return end->get_future();
}

TEST(ThreadPoolFailure, EndsItsJobAloneAndTheNextOneRuns) {
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads, 4);
    for (const std::size_t tiles : {1, 2, 3, 5, 4001}) {
      std::atomic<std::size_t> begun{0};
      const auto last_throws = [&](std::size_t tile) {
        ++begun;
        if (tile + 1 == tiles) throw std::runtime_error("the last tile");
      };
      auto good = submit(pool, tiles, [](std::size_t) {});
      EXPECT_EQ(submit(pool, tiles, last_throws).get(), "the last tile");
      EXPECT_EQ(begun, tiles);
      EXPECT_EQ(good.get(), "completed");
      EXPECT_EQ(submit(pool, tiles, [](std::size_t) {}).get(), "completed");
    }
    while (pool.jobs() > 0) std::this_thread::yield();
  }
}

TEST(ThreadPoolFailure, AbandonsTheTilesThatHaveNotBegun) {
  ThreadPool pool(1, 4);
  std::size_t begun = 0;  // touched by the pool's one thread, then after the job's end
  const auto third_throws = [&](std::size_t) {
    if (++begun == 3) throw std::bad_alloc();
  };
  EXPECT_EQ(submit(pool, 4001, third_throws).get(), std::bad_alloc().what());
  EXPECT_EQ(begun, 3U);
}

TEST(ThreadPoolFailure, IsTheFirstOfManyAndIsToldOnce) {
  ThreadPool pool(4, 4);
  for (int round = 0; round < 200; ++round) {
    EXPECT_EQ(submit(pool, 50, [](std::size_t) { throw std::bad_variant_access(); }).get(),
              std::bad_variant_access().what());
  }
}

TEST(ThreadPoolFailure, MayComeFromTheQuestionWhetherToStop) {
  ThreadPool pool(2, 4);
  const auto stop = []() -> bool { throw std::logic_error("no answer"); };
  EXPECT_EQ(submit(
                pool, 5, [](std::size_t) {}, stop)
                .get(),
            "no answer");
}

TEST(ThreadPoolFailure, IsAnAbandonedJobToWhoeverHasNoUseForIt) {
  ThreadPool pool(2, 4);
  std::promise<bool> done;
  ASSERT_TRUE(pool.submit(
      {2, [](std::size_t) { throw 1; }, {}, [&](bool completed) { done.set_value(completed); }}));
  EXPECT_FALSE(done.get_future().get());
}

TEST(ThreadPoolFailure, IsThrownByRunOnceNoTileIsUnderWay) {
  for (const bool brief : {false, true}) {
    ThreadPool pool(3, 1);
    for (const std::size_t tiles : {1, 2, 3, 5, 4001}) {
      std::atomic<int> under_way{0};
      const auto one_throws = [&](std::size_t tile) {
        ++under_way;
        std::this_thread::yield();
        --under_way;
        if (tile == tiles / 2) throw std::runtime_error("the middle one");
      };
      EXPECT_THROW(pool.run(tiles, one_throws, brief), std::runtime_error);
      EXPECT_EQ(under_way, 0);
      std::atomic<std::size_t> count{0};
      pool.run(
          tiles, [&](std::size_t) { ++count; }, brief);
      EXPECT_EQ(count, tiles);
    }
    while (pool.jobs() > 0) std::this_thread::yield();
  }
}

}  // namespace
}  // namespace gonio
