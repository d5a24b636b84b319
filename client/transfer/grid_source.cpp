#include <algorithm>

#include "client/transfer/pair_transfer.h"
#include "wire/fields.h"

namespace gonio::client {

GridSource::GridSource(const Grid& grid) : size_(*grid.size()) {
  using G = gonio::v1::Grid;
  if (grid.half_angle()) {
    axes_ = {{&grid.theta_h, &G::mutable_theta_h},
             {&grid.theta_d, &G::mutable_theta_d},
             {&grid.phi_d, &G::mutable_phi_d}};
  } else {
    axes_ = {{&grid.theta_i, &G::mutable_theta_i},
             {&grid.phi_i, &G::mutable_phi_i},
             {&grid.theta_o, &G::mutable_theta_o},
             {&grid.phi_o, &G::mutable_phi_o}};
  }
}

Result<std::optional<OutgoingChunk>> GridSource::next(std::size_t limit) {
  const std::size_t pairs = std::min<std::uint64_t>(size_ - first_, limit);
  if (pairs == 0) return std::optional<OutgoingChunk>{};
  gonio::v1::Grid grid;
  std::uint64_t first = first_;  // within the axes not yet cut
  std::uint64_t last = first + pairs - 1;
  std::uint64_t inner = size_;  // pairs for each angle of the axis at hand
  for (const NamedAxis& axis : axes_) {
    inner /= axis.angles->size();
    // As long as all of the run shares one angle of every axis before, this one can be cut as well.
    const bool cut = first / inner / axis.angles->size() == last / inner / axis.angles->size();
    const std::uint64_t from = cut ? first / inner : 0;
    const std::uint64_t to = cut ? last / inner : axis.angles->size() - 1;
    const auto begin = axis.angles->begin();
    (grid.*axis.field)()->Assign(begin + static_cast<std::ptrdiff_t>(from),
                                 begin + static_cast<std::ptrdiff_t>(to + 1));
    first -= from * inner;
    last -= from * inner;
  }
  grid.set_first(first);
  grid.set_count(pairs);
  OutgoingChunk chunk{first_, pairs};
  wire::put_header(chunk.head, gonio::v1::EvaluateRequest::kGridFieldNumber, grid.ByteSizeLong());
  grid.AppendToString(&chunk.head);
  first_ += pairs;
  return std::optional(std::move(chunk));
}

}  // namespace gonio::client
