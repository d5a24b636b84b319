#include "wire/bytes.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gonio::wire {

SliceBytes::SliceBytes(std::vector<grpc::Slice> slices) : slices_(std::move(slices)) {
  ends_.reserve(slices_.size());
  std::size_t end = 0;
  for (const grpc::Slice& slice : slices_) ends_.push_back(end += slice.size());
}

SliceBytes SliceBytes::of(const grpc::ByteBuffer& buffer) {
  std::vector<grpc::Slice> slices;
  if (!buffer.Valid() || !buffer.Dump(&slices).ok()) return {};
  return SliceBytes(std::move(slices));
}

SliceBytes::Piece SliceBytes::piece(std::size_t offset) const {
  // upper_bound, so that empty slices are stepped over.
  const auto found = std::upper_bound(ends_.begin(), ends_.end(), offset);
  if (found == ends_.end()) return {};
  const grpc::Slice& slice = slices_[static_cast<std::size_t>(found - ends_.begin())];
  const std::size_t left = *found - offset;
  return {slice.end() - left, left};
}

void SliceBytes::copy(std::size_t offset, std::size_t count, void* to) const {
  auto* out = static_cast<std::uint8_t*>(to);
  while (count > 0) {
    const Piece from = piece(offset);
    if (from.size == 0) return;
    const std::size_t step = std::min(count, from.size);
    std::memcpy(out, from.data, step);
    out += step;
    offset += step;
    count -= step;
  }
}

std::string SliceBytes::text(std::size_t offset, std::size_t count) const {
  std::string result(count, '\0');
  copy(offset, count, result.data());
  return result;
}

}  // namespace gonio::wire
