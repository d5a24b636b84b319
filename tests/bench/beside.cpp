// What an evaluation stream feels of long work beside it: the 99th percentile of the time that a
// chunk takes, idle and beside two calls of a kind. Wanted of fits: a ratio below 3.
//
//   beside [fit|assess|select|chart [SECONDS]]
//
// Idle and busy phases take turns within one run, so that other work on the machine slows both. The
// server is a goniod of its own, with its default options.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "client/support/pairs.h"
#include "gonio/client/client.h"
#include "server/support/daemon.h"

namespace gonio::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kChunkPairs = 16384, kFitPairs = 50'000;
constexpr int kPhases = 4;  // of each kind

client::Material material() {
  return client::Material::sum(
      client::Lobe{"lambertian", {{"rd", std::vector{0.3, 0.1, 0.05}}}},
      {client::Lobe{"ggx", {{"f0", 0.2}, {"alpha_x", 0.2}, {"alpha_y", 0.2}}}});
}

client::Client connect(const std::string& target) {
  client::ClientOptions options;
  options.chunk_pairs = kChunkPairs;
  options.in_flight = 1;  // a chunk's time is then its own
  return std::move(client::Client::connect(target, options)).value();
}

// Streams chunks for a while; adds the milliseconds of each.
bool stream(const client::Client& client, double seconds, std::vector<double>& times) {
  const test::RandomPairs<float> pairs(kChunkPairs);
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  Clock::time_point asked;
  const client::PairSource<float> source = [&](std::span<float> wi, std::span<float> wo) {
    asked = Clock::now();
    if (asked > end) return Result<std::size_t>(0);
    std::copy(pairs.wi.begin(), pairs.wi.end(), wi.begin());
    std::copy(pairs.wo.begin(), pairs.wo.end(), wo.begin());
    return Result<std::size_t>(kChunkPairs);
  };
  const client::ChunkSink<float, float> sink = [&](const auto&) {
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - asked).count());
    return Ok{};
  };
  return client.evaluate_chunks<float, float>(material(), source, sink).ok();
}

// A kind of work; each call is one job, begun and ended. They give errors only.
using Work = std::function<Result<Ok>(const client::Client&)>;

template <class T>
Result<Ok> ok_or_error(const Result<T>& result) {
  if (!result) return result.error();
  return Ok{};
}

Result<Ok> fit(const client::Client& client) {
  const test::RandomPairs<float> pairs(kFitPairs);
  thread_local std::vector<float> values;  // once: to make them is evaluation, too
  if (values.empty()) {
    values.resize(3 * kFitPairs);
    const auto report = client.evaluate(material(), pairs.wi, pairs.wo, values);
    if (!report) return report.error();
  }
  const client::FitData data{pairs.wi, pairs.wo, values, 3, {}, {}};
  const auto form = client::Material::sum(client::Lobe{"lambertian", {}},
                                          {client::Lobe{"ggx", {{"fresnel", "dielectric"}}}});
  return ok_or_error(client.fit(data, form));
}

Result<Ok> select(const client::Client& client) {
  client::SelectScene scene;
  scene.bins = {{.theta_i = {0, 1.3}, .theta_o = {0, 1.3}}};
  scene.tolerance = 0.05;
  return ok_or_error(client.select(material(), scene));
}

Result<Ok> chart(const client::Client& client) {
  client::ChartOptions options;
  options.parts = {"models"};
  return ok_or_error(client.chart(options));
}

Result<Ok> assess(const client::Client& client) { return ok_or_error(client.assess(material())); }

const std::map<std::string, Work, std::less<>> kinds = {
    {"fit", fit}, {"assess", assess}, {"select", select}, {"chart", chart}};

// One job after the other until it is told to stop, the last one to its end; counts them.
bool work_on(const client::Client& client, const Work& work, const std::atomic<bool>& stop,
             std::atomic<int>& ended) {
  do {
    if (const auto done = work(client); !done)
      return std::fprintf(stderr, "%s\n", done.error().message.c_str()), false;
    ++ended;
  } while (!stop);
  return true;
}

double percentile(std::vector<double>& times, double part) {
  if (times.empty()) return 0;
  std::sort(times.begin(), times.end());
  return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
}

void print(const char* name, std::vector<double>& times) {
  std::printf("%-18s %8zu %10.3f %10.3f\n", name, times.size(), percentile(times, 0.5),
              percentile(times, 0.99));
}

int run(const std::string& kind, const Work& work, double seconds) {
  server::testing::Daemon daemon({"--listen", "127.0.0.1:0"});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  const auto client = connect(target);
  std::vector<double> warm, idle, busy;
  if (!stream(client, 0.2, warm)) return 1;
  std::atomic<int> ended{0};
  std::atomic<bool> good{true};
  for (int phase = 0; phase < kPhases && good; ++phase) {
    good = stream(client, seconds, idle);
    std::atomic<bool> stop{false};
    std::vector<std::thread> threads;
    for (int i = 0; i < 2; ++i)
      threads.emplace_back([&] {
        if (!work_on(connect(target), work, stop, ended)) good = false;
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // until both work
    if (!stream(client, seconds, busy)) good = false;
    stop = true;
    for (auto& thread : threads) thread.join();
  }
  if (!good) return std::fprintf(stderr, "beside: a stream or a %s failed\n", kind.c_str()), 1;
  std::printf("%-18s %8s %10s %10s\n", "", "chunks", "p50 ms", "p99 ms");
  print("idle", idle);
  print(("beside two: " + kind).c_str(), busy);
  std::printf("p99 ratio %.2f; %d jobs ended\n", percentile(busy, 0.99) / percentile(idle, 0.99),
              ended.load());
  return 0;
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  const auto kind = gonio::bench::kinds.find(argc > 1 ? argv[1] : "fit");
  const double seconds = argc > 2 ? std::atof(argv[2]) : 2;
  if (kind == gonio::bench::kinds.end() || !(seconds > 0))
    return std::fputs("usage: beside [fit|assess|select|chart [SECONDS]]\n", stderr), 2;
  return gonio::bench::run(kind->first, kind->second, seconds);
}
