#include "client/rpc/open_call.h"

#include <chrono>
#include <thread>
#include <utility>

namespace gonio::client {
namespace {

using Clock = std::chrono::system_clock;

// gRPC's own news of a deadline takes a moment.
constexpr std::chrono::milliseconds kGrace{200};

bool drained(grpc::CompletionQueue& queue, Clock::time_point until) {
  for (;;) {
    void* tag = nullptr;
    bool ok = false;
    const auto event = queue.AsyncNext(&tag, &ok, until);
    if (event != grpc::CompletionQueue::GOT_EVENT) {
      return event == grpc::CompletionQueue::SHUTDOWN;
    }
  }
}

}  // namespace

OpenCall::OpenCall(const Patience& patience, std::unique_ptr<grpc::CompletionQueue> own_queue)
    : queue(std::move(own_queue)) {
  if (patience.deadline()) context.set_deadline(*patience.deadline());
}

bool OpenCall::next(void** tag, bool* ok) {
  if (context.deadline() == Clock::time_point::max()) return queue->Next(tag, ok);
  return queue->AsyncNext(tag, ok, context.deadline() + kGrace) == grpc::CompletionQueue::GOT_EVENT;
}

void EndCall::operator()(OpenCall* call) const {
  std::unique_ptr<OpenCall> owned(call);
  if (!owned->queue) return;
  owned->context.TryCancel();
  owned->queue->Shutdown();
  if (drained(*owned->queue, Clock::now() + kGrace)) return;
  std::thread([owned = std::move(owned)] {
    drained(*owned->queue, Clock::time_point::max());
  }).detach();
}

}  // namespace gonio::client
