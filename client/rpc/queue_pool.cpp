#include "client/rpc/queue_pool.h"

#include <utility>

namespace gonio::client {

std::unique_ptr<grpc::CompletionQueue> QueuePool::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto queue = std::move(idle_.back());
      idle_.pop_back();
      return queue;
    }
  }
  return std::make_unique<grpc::CompletionQueue>();
}

void QueuePool::give_back(std::unique_ptr<grpc::CompletionQueue> queue) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(queue));
}

}  // namespace gonio::client
