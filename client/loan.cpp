#include "client/loan.h"

#include <grpcpp/completion_queue.h>

#include <chrono>

namespace gonio::client {

void Loan::give_back(void* loan) { --static_cast<Loan*>(loan)->lent_; }

grpc::Slice Loan::lend(const void* data, std::size_t bytes) {
  ++lent_;
  return {const_cast<void*>(data), bytes, give_back, this};  // gRPC does not write to it
}

Loan::~Loan() {
  if (lent_ == 0) return;
  // gRPC gives back what a cancelled call was sending only while some thread attends to its
  // connections: this one does.
  grpc::CompletionQueue queue;
  void* tag = nullptr;
  bool ok = false;
  while (lent_ != 0) {
    queue.AsyncNext(&tag, &ok, std::chrono::system_clock::now() + std::chrono::milliseconds(1));
  }
  queue.Shutdown();
  while (queue.Next(&tag, &ok)) {
  }
}

}  // namespace gonio::client
