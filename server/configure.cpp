#include "server/configure.h"

#include <grpcpp/resource_quota.h>
#include <grpcpp/server_builder.h>
#include <malloc.h>

namespace gonio::server {

void configure(grpc::ServerBuilder& builder, const ServerOptions& options) {
  using Option = grpc::ServerBuilder::SyncServerOption;
  const int max_bytes = static_cast<int>(options.max_message_bytes);
  builder.SetMaxReceiveMessageSize(max_bytes).SetMaxSendMessageSize(max_bytes);
  builder.SetResourceQuota(grpc::ResourceQuota("gonio").Resize(options.memory_quota_bytes));
  // gRPC inflates a message before it looks at its size: half a megabyte may become half a
  // gigabyte.
  builder.SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_GZIP, false);
  builder.SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_DEFLATE, false);
  // Two servers on one port would share its calls at random.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  // Clients look twice a minute whether this machine is still there; gRPC takes that for an attack
  // unless it is told otherwise.
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
  // Only reflection uses the synchronous API: one thread is enough for it.
  builder.SetSyncServerOption(Option::NUM_CQS, 1);
  builder.SetSyncServerOption(Option::MIN_POLLERS, 1);
  builder.SetSyncServerOption(Option::MAX_POLLERS, 1);
}

void keep_freed_memory() {
  // Above what gRPC allocates at a time, so that its buffers come from the heap; glibc's own choice
  // moves with what is freed.
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
}

}  // namespace gonio::server
