// What gRPC itself costs: raw methods beside gonio's that do nothing but move bytes.
#pragma once

#include <grpcpp/impl/codegen/service_type.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <cstddef>

namespace gonio::bench {

inline constexpr const char* kEchoMethod = "/gonio.bench.Echo/Stream";
inline constexpr const char* kEmptyMethod = "/gonio.bench.Echo/Empty";

// Echo/Stream answers each message with its first `reply_bytes` bytes, without a copy; Echo/Empty
// answers nothing with nothing. Thread safety: as gRPC calls it.
class EchoService final : public grpc::Service {
 public:
  explicit EchoService(std::size_t reply_bytes);
};

}  // namespace gonio::bench
