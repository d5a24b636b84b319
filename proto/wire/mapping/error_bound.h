// An error bound on the wire. Thread safety: functions without state.
#pragma once

#include "gonio/base/stated_bound.h"
#include "gonio/v1/evaluate.pb.h"
#include "wire/mapping/mapping.h"

namespace gonio::wire {

template <>
struct Mapping<StatedBound> {
  using Own = StatedBound;
  using Message = v1::ErrorBound;
  static constexpr auto kFields = fields<Own>(field(&Own::relative, Message::kRelativeFieldNumber),
                                              field(&Own::above, Message::kAboveFieldNumber),
                                              field(&Own::cosine, Message::kCosineFieldNumber),
                                              field(&Own::note, Message::kNoteFieldNumber));
};

}  // namespace gonio::wire
