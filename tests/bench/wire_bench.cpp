// What the service costs beyond gRPC itself: throughput and latency against an echo on the same
// server, and memory.
//
// The two sides of a comparison take turns within one run, so that a machine with other work slows
// both. Wanted: stream echo_ratio >= 0.8 (carrying_echo_ratio is against an echo that reads and
// writes the caller's arrays, too), unary latency_ratio <= 1.2, memory < 100 MB on either
// side.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/echo_client.h"
#include "bench/resident.h"
#include "bench/wire_server.h"
#include "gonio/client/client.h"
#include "server/support/daemon.h"
#include "timing/spread.h"
#include "wire/codec.h"
#include "wire/convert.h"

namespace gonio::bench {
namespace {

constexpr std::size_t kChunkPairs = 65536;
constexpr std::size_t kInFlight = 4;
constexpr std::size_t kChannels = 3;
constexpr int kCalls = 32;  // in turn with as many of the other side
constexpr const char* kMaterial =
    R"({"model": "ashikhmin_shirley", "parameters": {"rd": [0.2, 0.1, 0.05],
    "rs": [0.9, 0.8, 0.5], "nu": 100, "nv": 1000}})";

client::Material material() { return *client::Material::from_json(kMaterial); }

WireServer& server() {
  static WireServer instance(kChunkPairs * kChannels * sizeof(float));
  return instance;
}

struct Arrays {
  std::vector<float> wi, wo, values;
  explicit Arrays(std::size_t pairs) : wi(3 * pairs), wo(3 * pairs), values(kChannels * pairs) {
    for (std::size_t i = 0; i < pairs; ++i) {
      // A golden-angle spiral over the hemisphere, and the same the other way round.
      const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(pairs),
                   r = std::sqrt(1 - z * z);
      const double phi = 2.399963229728653 * static_cast<double>(i);
      set(&wi[3 * i], r * std::cos(phi), r * std::sin(phi), z);
      set(&wo[3 * i], z * std::sin(phi), z * std::cos(phi), r);
    }
  }
  static void set(float* to, double x, double y, double z) {
    to[0] = static_cast<float>(x);
    to[1] = static_cast<float>(y);
    to[2] = static_cast<float>(z);
  }
};

// Time on the clock, and on all processors by all threads of this process, client's and server's.
struct Spent {
  double seconds = 0, cpu_seconds = 0;
  Spent& operator+=(const Spent& other) {
    seconds += other.seconds;
    cpu_seconds += other.cpu_seconds;
    return *this;
  }
};

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Spent spent_on(const std::function<bool()>& work, benchmark::State& state) {
  const auto start = std::chrono::steady_clock::now();
  const double cpu_start = cpu_now();
  if (!work()) state.SkipWithError("a call failed");
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          cpu_now() - cpu_start};
}

std::shared_ptr<grpc::Channel> channel_to(const std::string& target) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);
  return grpc::CreateCustomChannel(target, grpc::InsecureChannelCredentials(), arguments);
}

// The request of a chunk, as the client writes it: the directions are lent, not copied; the
// material goes with the first.
grpc::ByteBuffer request_of(const Arrays& arrays, std::size_t chunk) {
  static const std::string head = [] {
    v1::EvaluateRequest request;
    *request.mutable_material() = *wire::material_from_json(kMaterial);
    return request.SerializeAsString();
  }();
  const auto lent = [chunk](const std::vector<float>& all) {
    return wire::borrow(std::span(all).subspan(3 * chunk * kChunkPairs, 3 * kChunkPairs));
  };
  const wire::PairSlices slices{lent(arrays.wi), lent(arrays.wo), false};
  return wire::encode_stream_request(chunk, 0, chunk == 0 ? head : std::string_view(), slices);
}

// An echo that only moves bytes: one message, which stays in the caches, and answers dropped.
EchoEnds bare_echo(const Arrays& arrays) {
  const grpc::ByteBuffer message = request_of(arrays, 0);
  return {[message](std::size_t) { return message; }, [](std::size_t, const grpc::ByteBuffer&) {}};
}

// An echo that moves the caller's bytes, as any client must: every chunk from the arrays that hold
// it, every answer into the array that wants it.
EchoEnds carrying_echo(Arrays& arrays) {
  const auto take = [&arrays](std::size_t chunk, const grpc::ByteBuffer& answer) {
    std::vector<grpc::Slice> slices;
    (void)answer.Dump(&slices);
    auto* to = reinterpret_cast<std::uint8_t*>(&arrays.values[chunk * kChunkPairs * kChannels]);
    for (const grpc::Slice& slice : slices) to = std::copy(slice.begin(), slice.end(), to);
  };
  return {[&arrays](std::size_t chunk) { return request_of(arrays, chunk); }, take};
}

// 64 k-pair chunks, 4 in flight, from the caller's arrays into the caller's arrays.
void stream_throughput(benchmark::State& state, const std::string& target) {
  const auto pairs = static_cast<std::size_t>(state.range(0));
  Arrays arrays(pairs);
  const auto bench_material = material();
  const auto connection = channel_to(target);
  const auto client = client::Client::from_channel(connection, target, {});
  const EchoEnds bare = bare_echo(arrays), carrying = carrying_echo(arrays);
  const auto evaluate = [&] {
    return client->evaluate(bench_material, arrays.wi, arrays.wo, arrays.values).ok();
  };
  const auto echo = [&](const EchoEnds& ends) {
    return [&, pairs] { return echo_stream(connection, ends, pairs / kChunkPairs, kInFlight); };
  };
  evaluate(), echo(bare)(), echo(carrying)();
  Spent evaluating, echoing, carried;
  std::vector<double> times;
  for (auto _ : state) {
    echoing += spent_on(echo(bare), state);
    carried += spent_on(echo(carrying), state);
    const Spent taken = spent_on(evaluate, state);
    evaluating += taken;
    times.push_back(taken.seconds);
    state.SetIterationTime(taken.seconds);
  }
  const double done = static_cast<double>(state.iterations()) * static_cast<double>(pairs);
  state.counters["pairs/s"] = done / evaluating.seconds;
  state.counters["best_pairs/s"] = static_cast<double>(pairs) / timing::spread_of(times).best;
  state.counters["echo_pairs/s"] = done / echoing.seconds;
  state.counters["echo_ratio"] = echoing.seconds / evaluating.seconds;
  state.counters["carrying_echo_ratio"] = carried.seconds / evaluating.seconds;
  state.counters["cpu_ns_a_pair"] = 1e9 * evaluating.cpu_seconds / done;
  state.counters["echo_cpu_ns_a_pair"] = 1e9 * echoing.cpu_seconds / done;
}

void unary_latency(benchmark::State& state, const std::string& target) {
  Arrays arrays(1);
  const auto bench_material = material();
  const auto connection = channel_to(target);
  const auto client = client::Client::from_channel(connection, target, {});
  const grpc::Slice nothing;
  const grpc::ByteBuffer empty(&nothing, 1);
  grpc::ByteBuffer response;
  const auto evaluate = [&] {
    return client->evaluate(bench_material, arrays.wi, arrays.wo, arrays.values).ok();
  };
  const auto call = [&] { return raw_unary(*connection, kEmptyMethod, empty, response); };
  const auto repeated = [](const auto& one) {
    return [&one] {
      for (int i = 1; i < kCalls; ++i) {
        if (!one()) return false;
      }
      return one();
    };
  };
  evaluate(), call();
  Spent evaluating, calling;
  std::vector<double> times;
  for (auto _ : state) {
    calling += spent_on(repeated(call), state);
    const Spent taken = spent_on(repeated(evaluate), state);
    evaluating += taken;
    times.push_back(taken.seconds / kCalls);
    state.SetIterationTime(taken.seconds);
  }
  const double calls = static_cast<double>(kCalls) * static_cast<double>(state.iterations());
  state.counters["best_us"] = 1e6 * timing::spread_of(times).best;
  state.counters["us"] = 1e6 * evaluating.seconds / calls;
  state.counters["empty_us"] = 1e6 * calling.seconds / calls;
  state.counters["latency_ratio"] = evaluating.seconds / calling.seconds;
  state.counters["cpu_us"] = 1e6 * evaluating.cpu_seconds / calls;
  state.counters["empty_cpu_us"] = 1e6 * calling.cpu_seconds / calls;
}

// Growth of both processes over a 16 M-pair stream; the server is a goniod of its own.
void memory(benchmark::State& state) {
  server::testing::Daemon daemon({"--listen", "127.0.0.1:0"});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  Arrays arrays(std::size_t{16} << 20);
  const auto bench_material = material();
  const auto client = client::Client::connect(target, {});
  double client_bytes = 0, server_bytes = 0;
  for (auto _ : state) {
    reset_peak(::getpid());
    const double client_before = resident_bytes(::getpid(), "VmRSS:");
    const double server_before = resident_bytes(daemon.pid(), "VmRSS:");
    if (!client->evaluate(bench_material, arrays.wi, arrays.wo, arrays.values).ok())
      state.SkipWithError("it failed");
    client_bytes = std::max(client_bytes, resident_bytes(::getpid(), "VmHWM:") - client_before);
    server_bytes = std::max(server_bytes, resident_bytes(daemon.pid(), "VmHWM:") - server_before);
  }
  state.counters["client_MB"] = 1e-6 * client_bytes;
  state.counters["server_MB"] = 1e-6 * server_bytes;
}

}  // namespace
}  // namespace gonio::bench

int main(int argc, char** argv) {
  using namespace gonio::bench;
  gonio::server::keep_freed_memory();  // as goniod does; the echo has the same advantage
  benchmark::Initialize(&argc, argv);
  // First, while this process is still small.
  benchmark::RegisterBenchmark("memory/16M_pairs", memory)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  for (const auto& [name, target] :
       {std::pair{"tcp", server().tcp_target}, std::pair{"unix", server().unix_target}}) {
    benchmark::RegisterBenchmark((std::string("stream/") + name).c_str(), stream_throughput, target)
        ->Arg(1 << 20)
        ->Arg(4 << 20)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->MinTime(3);
    benchmark::RegisterBenchmark((std::string("unary/") + name).c_str(), unary_latency, target)
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond)
        ->MinTime(2);
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
