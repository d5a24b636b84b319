#include "wire/bytes.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gonio::wire {

SliceBytes::SliceBytes(const grpc::ByteBuffer& buffer, std::vector<grpc::Slice> slices) {
  if (slices.empty()) return;
  Content content{buffer, std::move(slices), {}};
  content.ends.reserve(content.slices.size());
  std::size_t end = 0;
  for (const grpc::Slice& slice : content.slices) content.ends.push_back(end += slice.size());
  content_ = std::make_shared<const Content>(std::move(content));
}

SliceBytes SliceBytes::of(const grpc::ByteBuffer& buffer) {
  std::vector<grpc::Slice> slices;
  if (!buffer.Valid() || !buffer.Dump(&slices).ok()) return {};
  return {buffer, std::move(slices)};
}

SliceBytes::Piece SliceBytes::piece(std::size_t offset) const {
  if (!content_) return {};
  const std::vector<grpc::Slice>& slices = content_->slices;
  const std::vector<std::size_t>& ends = content_->ends;
  // upper_bound, so that empty slices are stepped over.
  const auto found = std::upper_bound(ends.begin(), ends.end(), offset);
  if (found == ends.end()) return {};
  const std::size_t left = *found - offset;
  return {slices[static_cast<std::size_t>(found - ends.begin())].end() - left, left};
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
