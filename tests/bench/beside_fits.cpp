// What an evaluation stream feels of two fits beside it: the 99th percentile of the time that a
// chunk takes, idle and with the fits. Wanted: a ratio below 3. beside_fits [SECONDS]
//
// Idle and busy phases take turns within one run, so that other work on the machine slows both. The
// server is a goniod of its own, with its default options.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "client/client.h"
#include "client/pairs.h"
#include "server/daemon.h"

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

// Fits one after the other until it is told to stop, the last one to its end; counts them. False if
// one fails.
bool fit_on(const client::Client& client, const std::atomic<bool>& stop, std::atomic<int>& fits) {
  const test::RandomPairs<float> pairs(kFitPairs);
  std::vector<float> values(3 * kFitPairs);
  if (!client.evaluate(material(), pairs.wi, pairs.wo, values)) return false;
  const client::FitData data{pairs.wi, pairs.wo, values, 3, {}, {}};
  const auto form = client::Material::sum(client::Lobe{"lambertian", {}},
                                          {client::Lobe{"ggx", {{"fresnel", "dielectric"}}}});
  do {
    const auto fit = client.fit(data, form);
    if (!fit) return std::fprintf(stderr, "%s\n", fit.error().message.c_str()), false;
    ++fits;
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

int run(double seconds) {
  testing::Daemon daemon({"--listen", "127.0.0.1:0"});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  const auto client = connect(target);
  std::vector<double> warm, idle, busy;
  if (!stream(client, 0.2, warm)) return 1;
  std::atomic<int> fits{0};
  std::atomic<bool> good{true};
  for (int phase = 0; phase < kPhases && good; ++phase) {
    good = stream(client, seconds, idle);
    std::atomic<bool> stop{false};
    std::vector<std::thread> threads;
    for (int i = 0; i < 2; ++i)
      threads.emplace_back([&] {
        if (!fit_on(connect(target), stop, fits)) good = false;
      });
    std::this_thread::sleep_for(std::chrono::milliseconds(300));  // until both fit
    if (!stream(client, seconds, busy)) good = false;
    stop = true;
    for (auto& thread : threads) thread.join();
  }
  if (!good) return std::fputs("beside_fits: a stream or a fit failed\n", stderr), 1;
  std::printf("%-18s %8s %10s %10s\n", "", "chunks", "p50 ms", "p99 ms");
  print("idle", idle);
  print("beside two fits", busy);
  std::printf("p99 ratio %.2f; %d fits ended\n", percentile(busy, 0.99) / percentile(idle, 0.99),
              fits.load());
  return 0;
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) { return gonio::bench::run(argc > 1 ? std::atof(argv[1]) : 2); }
