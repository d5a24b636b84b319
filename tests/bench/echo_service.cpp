#include "bench/echo_service.h"

#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/server_context.h>

#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace gonio::bench {
namespace {

using grpc::ByteBuffer;

ByteBuffer first_bytes(const ByteBuffer& message, std::size_t count) {
  std::vector<grpc::Slice> slices, kept;
  (void)message.Dump(&slices);
  for (const grpc::Slice& slice : slices) {
    if (count == 0) break;
    kept.push_back(slice.size() <= count ? slice : slice.sub(0, count));
    count -= kept.back().size();
  }
  return {kept.data(), kept.size()};
}

// Reads ahead of its writes as gonio's own stream does, up to as many messages.
class EchoStream final : public grpc::ServerBidiReactor<ByteBuffer, ByteBuffer> {
 public:
  explicit EchoStream(std::size_t reply_bytes) : reply_bytes_(reply_bytes) { pump(); }

 private:
  static constexpr std::size_t kMaxInFlight = 8;

  void OnReadDone(bool ok) override {
    ByteBuffer reply;
    if (ok) reply = first_bytes(incoming_, reply_bytes_);
    {
      const std::lock_guard lock(mutex_);
      reading_ = false;
      over_ = over_ || !ok;
      if (ok) ready_.push_back(std::move(reply));
    }
    pump();
  }

  void OnWriteDone(bool ok) override {
    {
      const std::lock_guard lock(mutex_);
      ready_.pop_front();
      writing_ = false;
      over_ = over_ || !ok;
    }
    pump();
  }

  void OnDone() override { delete this; }

  void pump() {
    bool read = false, write = false, finish = false;
    {
      const std::lock_guard lock(mutex_);
      read = !reading_ && !over_ && ready_.size() < kMaxInFlight;
      write = !writing_ && !ready_.empty();
      finish = over_ && !reading_ && ready_.empty() &&
               !std::exchange(finished_, over_ && !reading_ && ready_.empty());
      reading_ = reading_ || read;
      writing_ = writing_ || write;
    }
    if (write) StartWrite(&ready_.front());
    if (read) StartRead(&incoming_);
    if (finish) Finish(grpc::Status::OK);
  }

  std::size_t reply_bytes_;
  ByteBuffer incoming_;
  std::mutex mutex_;
  std::deque<ByteBuffer> ready_;
  bool reading_ = false, writing_ = false, over_ = false, finished_ = false;
};

}  // namespace

// What the generated code does for a service with raw callback methods.
EchoService::EchoService(std::size_t reply_bytes) {
  using grpc::internal::RpcMethod;
  AddMethod(new grpc::internal::RpcServiceMethod(kEchoMethod, RpcMethod::BIDI_STREAMING, nullptr));
  AddMethod(new grpc::internal::RpcServiceMethod(kEmptyMethod, RpcMethod::NORMAL_RPC, nullptr));
  MarkMethodRawCallback(
      0, new grpc::internal::CallbackBidiHandler<ByteBuffer, ByteBuffer>(
             [reply_bytes](grpc::CallbackServerContext*) { return new EchoStream(reply_bytes); }));
  MarkMethodRawCallback(
      1, new grpc::internal::CallbackUnaryHandler<ByteBuffer, ByteBuffer>(
             [](grpc::CallbackServerContext* context, const ByteBuffer*, ByteBuffer* response) {
               const grpc::Slice nothing;
               *response = ByteBuffer(&nothing, 1);
               auto* reactor = context->DefaultReactor();
               reactor->Finish(grpc::Status::OK);
               return reactor;
             }));
}

}  // namespace gonio::bench
