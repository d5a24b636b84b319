// The bytes of a gRPC message as they lie in memory: several slices, addressed as if they were one
// array.
//
// Nothing is copied but what copy() is asked for. Thread safety: immutable, read from many threads
// at once; the last copy may end on any thread, also on one that gRPC knows nothing of.
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
  // Of memory that gRPC has not received, such as grpc::Slice(std::string).
  explicit SliceBytes(std::vector<grpc::Slice> slices) : SliceBytes({}, std::move(slices)) {}
  // Empty for a buffer that cannot be read (such as one with a broken compression).
  static SliceBytes of(const grpc::ByteBuffer& buffer);

  [[nodiscard]] std::size_t size() const { return content_ ? content_->ends.back() : 0; }

  // Copies bytes offset ... offset + count - 1, which must exist.
  void copy(std::size_t offset, std::size_t count, void* to) const;
  [[nodiscard]] std::string text(std::size_t offset, std::size_t count) const;

  // The bytes that lie together from `offset` on: at least one where offset < size().
  struct Piece {
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
  };
  [[nodiscard]] Piece piece(std::size_t offset) const;

 private:
  SliceBytes(const grpc::ByteBuffer& buffer, std::vector<grpc::Slice> slices);

  struct Content {
    // Ends after the slices, so that theirs are never the last references to received memory: gRPC
    // 1.51 gives such memory back to its quota, and under pressure does so only where it has an
    // execution context. The end of a buffer makes one, the end of a slice does not.
    grpc::ByteBuffer buffer;
    std::vector<grpc::Slice> slices;
    std::vector<std::size_t> ends;  // the offset after each slice
  };
  std::shared_ptr<const Content> content_;  // copies share the bytes; null if there are none
};

}  // namespace gonio::wire
