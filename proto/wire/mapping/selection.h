// A selection's result and progress on the wire, with any kind of material that has a mapping.
// Thread safety: functions without state.
#pragma once

#include "gonio/select/selection.h"
#include "gonio/v1/select.pb.h"
#include "wire/mapping/mapping.h"

namespace gonio::wire {

template <>
struct Mapping<select::Progress> {
  using Own = select::Progress;
  using Message = v1::SelectProgress;
  static constexpr auto kFields =
      fields<Own>(field(&Own::stage, Message::kStageFieldNumber),
                  field(&Own::candidate, Message::kCandidateFieldNumber),
                  field(&Own::done, Message::kDoneFieldNumber),
                  field(&Own::of, Message::kCandidatesFieldNumber));
};

template <>
struct Mapping<select::Bounded> {
  using Own = select::Bounded;
  using Message = v1::SelectError;
  static constexpr auto kFields = fields<Own>(field(&Own::value, Message::kValueFieldNumber),
                                              field(&Own::lower, Message::kLowerFieldNumber),
                                              field(&Own::upper, Message::kUpperFieldNumber));
};

template <class Material>
struct Mapping<select::EntryOf<Material>> {
  using Own = select::EntryOf<Material>;
  using Message = v1::SelectEntry;
  static constexpr auto kFields = fields<Own>(
      field(&Own::name, Message::kNameFieldNumber),
      field(&Own::material, Message::kMaterialFieldNumber),
      field(&Own::parameters, Message::kParametersFieldNumber),
      field(&Own::ns, Message::kNsFieldNumber), field(&Own::bytes, Message::kBytesFieldNumber),
      field(&Own::second_moment, Message::kSecondMomentFieldNumber),
      field(&Own::cost, Message::kCostFieldNumber), field(&Own::error, Message::kErrorFieldNumber),
      field(&Own::at_bounds, Message::kAtBoundsFieldNumber),
      field(&Own::on_front, Message::kOnFrontFieldNumber),
      field(&Own::meets, Message::kMeetsFieldNumber),
      field(&Own::remark, Message::kRemarkFieldNumber));
};

template <class Material>
struct Mapping<select::ChoiceOf<Material>> {
  using Own = select::ChoiceOf<Material>;
  using Message = v1::SelectChoice;
  static constexpr auto kFields =
      fields<Own>(field(&Own::entry, Message::kEntryFieldNumber),
                  field(&Own::material, Message::kMaterialFieldNumber),
                  field(&Own::digits, Message::kDigitsFieldNumber),
                  field(&Own::needs_float64, Message::kNeedsFloat64FieldNumber),
                  field(&Own::float32_error, Message::kFloat32ErrorFieldNumber),
                  field(&Own::error, Message::kErrorFieldNumber),
                  field(&Own::confidence, Message::kConfidenceFieldNumber),
                  field(&Own::pairs, Message::kPairsFieldNumber));
};

template <class Material>
struct Mapping<select::SelectionOf<Material>> {
  using Own = select::SelectionOf<Material>;
  using Message = v1::SelectResult;
  static constexpr auto kFields = fields<Own>(field(&Own::entries, Message::kEntriesFieldNumber),
                                              field(&Own::choice, Message::kChoiceFieldNumber),
                                              field(&Own::reason, Message::kReasonFieldNumber));
};

}  // namespace gonio::wire
