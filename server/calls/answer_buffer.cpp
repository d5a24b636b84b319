#include "server/calls/answer_buffer.h"

#include <cstdlib>

namespace gonio::server {

std::optional<AnswerBuffer> AnswerBuffer::allocate(std::size_t bytes) {
  if (bytes == 0) return AnswerBuffer{};
  constexpr std::size_t kAlignment = 64;
  void* data = std::aligned_alloc(kAlignment, (bytes + kAlignment - 1) / kAlignment * kAlignment);
  if (data == nullptr) return std::nullopt;
  return AnswerBuffer{data, grpc::Slice(data, bytes, [](void* memory) { std::free(memory); })};
}

}  // namespace gonio::server
