// An error bound that owns its words: as it travels, and as the client library gives it. Thread
// safety: plain values.
#pragma once

#include <string>

namespace gonio {

// |f - truth| <= relative * truth wherever truth > above and both cosines > cosine. `note` says
// where that does not hold, or is tighter; empty if it simply holds.
struct StatedBound {
  double relative = 0;
  double above = 0;
  double cosine = 0;
  std::string note;
};

// Of a model's bound (gonio/models/description.h), which refers to its note.
template <class Bound>
StatedBound stated(const Bound& bound) {
  return {bound.relative, bound.above, bound.cosine, std::string(bound.note)};
}

}  // namespace gonio
