// Completion queues for unary calls, used one after the other. Internal to the client library.
//
// Making a queue and shutting it down costs a tenth of a small call. Thread safety: any thread.
#pragma once

#include <grpcpp/completion_queue.h>

#include <memory>
#include <mutex>
#include <vector>

namespace gonio::client {

class QueuePool {
 public:
  // A queue that nothing is due to come from; a new one if all are in use.
  std::unique_ptr<grpc::CompletionQueue> take();
  // Nothing may be due to come from `queue`.
  void give_back(std::unique_ptr<grpc::CompletionQueue> queue);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<grpc::CompletionQueue>> idle_;
};

}  // namespace gonio::client
