#include "client/rpc/loan.h"

#include <chrono>

#include "base/happens_before.h"
#include "client/rpc/wait.h"

namespace gonio::client {

void Loan::give_back(void* loan) {
  happens_after(loan);
  --static_cast<Loan*>(loan)->lent_;
}

grpc::Slice Loan::lend(const void* data, std::size_t bytes) {
  ++lent_;
  happens_before(this);
  return {const_cast<void*>(data), bytes, give_back, this};  // gRPC does not write to it
}

Loan::~Loan() {
  if (lent_ == 0) return;
  wait_until(std::chrono::system_clock::time_point::max(), [this] { return lent_ == 0; });
}

}  // namespace gonio::client
