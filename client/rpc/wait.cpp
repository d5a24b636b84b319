#include "client/rpc/wait.h"

#include <grpcpp/completion_queue.h>

#include <algorithm>

namespace gonio::client {
namespace {

using Clock = std::chrono::system_clock;

// A queue to which nothing is ever added: waiting for it does gRPC's work and nothing else.
class EmptyQueue {
 public:
  ~EmptyQueue() {
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  void wait(Clock::time_point until) {
    void* tag = nullptr;
    bool ok = false;
    queue_.AsyncNext(&tag, &ok, until);
  }

 private:
  grpc::CompletionQueue queue_;
};

}  // namespace

void wait_until(Clock::time_point until, const std::function<bool()>& done) {
  EmptyQueue queue;
  while (!done() && Clock::now() < until) {
    queue.wait(std::min(until, Clock::now() + std::chrono::milliseconds(1)));
  }
}

void wait_until(Clock::time_point until) {
  EmptyQueue queue;
  while (Clock::now() < until) queue.wait(until);
}

}  // namespace gonio::client
