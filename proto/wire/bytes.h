// The bytes of a gRPC message as they lie in memory: several slices, addressed as if they were one
// array.
//
// Only copy() copies bytes. Thread safety: immutable, read from many threads at once. The last copy
// may be destroyed on any thread, also on one that gRPC did not start.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/slice.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gonio::wire {

class SliceBytes {
 public:
  SliceBytes() = default;
  // For memory that gRPC has not received, such as grpc::Slice(std::string).
  explicit SliceBytes(std::vector<grpc::Slice> slices) : SliceBytes({}, std::move(slices)) {}
  // Empty for a buffer that cannot be read (such as one with a broken compression).
  static SliceBytes of(const grpc::ByteBuffer& buffer);

  [[nodiscard]] std::size_t size() const { return content_ ? content_->ends.back() : 0; }

  // Copies bytes offset ... offset + count - 1, which must exist.
  void copy(std::size_t offset, std::size_t count, void* to) const;
  [[nodiscard]] std::string text(std::size_t offset, std::size_t count) const;

  // The contiguous bytes from `offset` on: at least one where offset < size().
  struct Piece {
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
  };
  [[nodiscard]] Piece piece(std::size_t offset) const;

 private:
  SliceBytes(const grpc::ByteBuffer& buffer, std::vector<grpc::Slice> slices);

  struct Content {
    // Destroyed after the slices, so that these never hold the last reference to received memory.
    // gRPC 1.51 returns such memory to its quota, and under pressure does so only in an execution
    // context. The destructor of a buffer creates one, that of a slice does not.
    grpc::ByteBuffer buffer;
    std::vector<grpc::Slice> slices;
    std::vector<std::size_t> ends;  // the offset after each slice
  };
  std::shared_ptr<const Content> content_;  // copies share the bytes; null if there are none
};

}  // namespace gonio::wire
