// Many streams that send chunks of 65,536 pairs as fast as the server takes them. Some of them read
// the answers, the others never do. One thread drives all of them.
#pragma once

#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/support/harness.h"

namespace gonio::server::testing {

class Flood {
 public:
  struct Result {
    int answers = 0;
    int broken = 0;  // streams that the server, or gRPC for it, ended
  };

  Flood(std::string target, int readers, int silent) : target_(std::move(target)) {
    v1::EvaluateStreamRequest chunk;
    *chunk.mutable_evaluate() = ggx_request(random_pairs(65536));
    const grpc::Slice slice(chunk.SerializeAsString());
    message_ = grpc::ByteBuffer(&slice, 1);
    for (int i = 0; i < readers + silent; ++i) streams_.push_back(open(i < readers));
  }
  ~Flood() {
    for (const auto& stream : streams_) stream->context.TryCancel();
    queue_.Shutdown();
    void* tag = nullptr;
    for (bool ok = false; queue_.Next(&tag, &ok);) {
    }
  }
  Flood(const Flood&) = delete;
  Flood& operator=(const Flood&) = delete;

  // A stream that breaks is opened again, on a connection of its own; so is one every 20 ms in any
  // case, in turn, so that connections begin and end all the time. Ends early where nearly all
  // break: then the server is gone.
  Result run(std::chrono::milliseconds time) {
    const auto end = Clock::now() + time;
    auto next_renewal = Clock::now();
    result_ = {};
    for (auto now = Clock::now(); now < end && result_.broken < kMostBroken; now = Clock::now()) {
      if (now >= next_renewal) {
        streams_[static_cast<std::size_t>(renewed_++) % streams_.size()]->renew();
        next_renewal = now + std::chrono::milliseconds(20);
      }
      void* tag = nullptr;
      bool ok = false;
      if (queue_.AsyncNext(&tag, &ok, std::min(end, next_renewal)) ==
          grpc::CompletionQueue::GOT_EVENT)
        take(*static_cast<Event*>(tag), ok);
    }
    return result_;
  }

 private:
  using Clock = std::chrono::system_clock;
  static constexpr int kMostBroken = 3000;

  enum class What { started, wrote, read, finished };
  struct Stream;
  struct Event {
    Stream* stream = nullptr;
    What what = What::started;
  };
  struct Stream {
    std::shared_ptr<grpc::Channel> channel;
    grpc::ClientContext context;
    std::unique_ptr<grpc::GenericClientAsyncReaderWriter> call;
    grpc::ByteBuffer incoming;
    grpc::Status status;
    bool reads = false, renewed = false, finishing = false;
    int pending = 0;
    std::array<Event, 4> events;

    void* begin(What what) {
      ++pending;
      return &events[static_cast<std::size_t>(what)];
    }
    void renew() {
      renewed = true;
      context.TryCancel();
    }
  };

  std::unique_ptr<Stream> open(bool reads) {
    auto stream = std::make_unique<Stream>();
    for (const What what : {What::started, What::wrote, What::read, What::finished})
      stream->events[static_cast<std::size_t>(what)] = {stream.get(), what};
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    arguments.SetMaxReceiveMessageSize(-1);
    stream->channel =
        grpc::CreateCustomChannel(target_, grpc::InsecureChannelCredentials(), arguments);
    stream->reads = reads;
    grpc::GenericStub stub(stream->channel);
    stream->call =
        stub.PrepareCall(&stream->context, "/gonio.v1.GonioService/EvaluateStream", &queue_);
    stream->call->StartCall(stream->begin(What::started));
    return stream;
  }

  void take(const Event& event, bool ok) {
    Stream& stream = *event.stream;
    --stream.pending;
    if (ok && event.what != What::finished) {
      go_on(stream, event.what);
    } else if (!std::exchange(stream.finishing, true)) {
      stream.call->Finish(&stream.status, stream.begin(What::finished));
    }
    if (stream.pending > 0) return;
    if (!stream.renewed) ++result_.broken;
    const auto place = std::find_if(streams_.begin(), streams_.end(),
                                    [&](const auto& other) { return other.get() == &stream; });
    *place = open(stream.reads);
  }

  void go_on(Stream& stream, What after) {
    if (after == What::read) ++result_.answers;
    if (after != What::read) stream.call->Write(message_, stream.begin(What::wrote));
    if (after == What::read || (after == What::started && stream.reads))
      stream.call->Read(&stream.incoming, stream.begin(What::read));
  }

  std::string target_;
  grpc::ByteBuffer message_;
  grpc::CompletionQueue queue_;
  std::vector<std::unique_ptr<Stream>> streams_;
  int renewed_ = 0;
  Result result_;
};

}  // namespace gonio::server::testing
