// The queue of fits and uploads: bounded, each job once, what nobody waits for gives its place
// back.
#include "server/work/background_queue.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <new>
#include <string>
#include <variant>

namespace gonio::server {
namespace {

BackgroundQueue::Job job(
    std::function<void()> run, std::function<bool()> is_over = [] { return false; }) {
  return {std::move(run), std::move(is_over)};
}

TEST(BackgroundQueue, RunsAllThatItTookBeforeItEnds) {
  std::atomic<int> runs{0};
  {
    BackgroundQueue queue(2, 100);
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(queue.submit(job([&] { ++runs; })));
  }
  EXPECT_EQ(runs, 100);
}

TEST(BackgroundQueue, RefusesOneMoreThanItTakes) {
  std::promise<void> go;
  std::atomic<int> runs{0};
  const auto wait = [&, open = go.get_future().share()] { open.wait(), ++runs; };
  {
    BackgroundQueue queue(1, 3);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(queue.submit(job(wait)));
    EXPECT_FALSE(queue.submit(job(wait)));
    EXPECT_EQ(queue.max_jobs(), 3U);
    go.set_value();
  }
  EXPECT_EQ(runs, 3);
}

TEST(BackgroundQueue, GivesThePlacesBackThatNobodyWaitsFor) {
  std::promise<void> go, begun;
  std::atomic<bool> over{false};
  std::atomic<int> dropped{0};
  BackgroundQueue queue(1, 2);
  ASSERT_TRUE(queue.submit(job([&] { begun.set_value(), go.get_future().wait(); })));
  begun.get_future().wait();
  ASSERT_TRUE(queue.submit(job([&] { ++dropped; }, [&] { return over.load(); })));
  queue.drop_over();
  EXPECT_EQ(dropped, 0);
  EXPECT_FALSE(queue.submit(job([] {})));
  over = true;
  queue.drop_over();
  EXPECT_EQ(dropped, 1);
  EXPECT_TRUE(queue.submit(job([] {})));
  go.set_value();
}

TEST(BackgroundQueue, GoesOnAfterAJobThatThrows) {
  BackgroundQueue queue(1, 100);
  for (int round = 0; round < 3; ++round) {
    std::promise<std::string> failed;
    std::promise<void> next;
    ASSERT_TRUE(queue.submit({[] { throw std::bad_variant_access(); }, [] { return false; },
                              [&](const std::exception_ptr& failure) {
                                try {
                                  std::rethrow_exception(failure);
                                } catch (const std::exception& error) {
                                  failed.set_value(error.what());
                                }
                              }}));
    ASSERT_TRUE(queue.submit(job([] { throw 1; })));  // of no use to anybody
    ASSERT_TRUE(queue.submit(job([&] { next.set_value(); })));
    EXPECT_EQ(failed.get_future().get(), std::bad_variant_access().what());
    next.get_future().wait();
  }
}

TEST(BackgroundQueue, TellsOfAJobThatThrowsWhenItIsDropped) {
  std::promise<void> go, begun;
  int failures = 0;
  BackgroundQueue queue(1, 2);
  ASSERT_TRUE(queue.submit(job([&] { begun.set_value(), go.get_future().wait(); })));
  begun.get_future().wait();
  ASSERT_TRUE(queue.submit({[] { throw std::bad_alloc(); }, [] { return true; },
                            [&](const std::exception_ptr&) { ++failures; }}));
  queue.drop_over();
  EXPECT_EQ(failures, 1);
  go.set_value();
}

TEST(BackgroundQueue, RunsBehindAllElse) {
  std::promise<int> priority;
  BackgroundQueue queue(1, 1);
  ASSERT_TRUE(queue.submit(job([&] { priority.set_value(getpriority(PRIO_PROCESS, 0)); })));
  EXPECT_EQ(priority.get_future().get(), 19);
  EXPECT_LT(getpriority(PRIO_PROCESS, 0), 19);
}

}  // namespace
}  // namespace gonio::server
