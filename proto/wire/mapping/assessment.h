// An assessment on the wire. Thread safety: functions without state.
#pragma once

#include <array>

#include "gonio/assess/report.h"
#include "gonio/v1/assess.pb.h"
#include "wire/mapping/error_bound.h"
#include "wire/mapping/mapping.h"

namespace gonio::wire {

template <>
struct Mapping<assess::Worst> {
  using Own = assess::Worst;
  using Message = v1::AssessWorst;
  static constexpr auto kFields = fields<Own>(
      field(&Own::error, Message::kErrorFieldNumber), field(&Own::wi, Message::kWiFieldNumber),
      field(&Own::wo, Message::kWoFieldNumber), field(&Own::channel, Message::kChannelFieldNumber),
      field(&Own::value, Message::kValueFieldNumber),
      field(&Own::truth, Message::kTruthFieldNumber));
};

template <>
struct Mapping<assess::Findings> {
  using Own = assess::Findings;
  using Message = v1::AssessFindings;
  static constexpr auto kFields = fields<Own>(field(&Own::nan, Message::kNanFieldNumber),
                                              field(&Own::infinite, Message::kInfiniteFieldNumber),
                                              field(&Own::negative, Message::kNegativeFieldNumber),
                                              field(&Own::stray, Message::kStrayFieldNumber),
                                              field(&Own::checked, Message::kCheckedFieldNumber),
                                              field(&Own::worst, Message::kWorstFieldNumber));
};

template <>
struct Mapping<assess::PlaceReport> {
  using Own = assess::PlaceReport;
  using Message = v1::AssessPlace;
  static constexpr auto kFields = fields<Own>(
      field(&Own::name, Message::kNameFieldNumber), field(&Own::where, Message::kWhereFieldNumber),
      field(&Own::failure, Message::kFailureFieldNumber),
      field(&Own::pairs, Message::kPairsFieldNumber), field(&Own::fast, Message::kFastFieldNumber),
      field(&Own::reference, Message::kReferenceFieldNumber),
      field(&Own::naive32, Message::kNaiveFloat32FieldNumber),
      field(&Own::naive64, Message::kNaiveFloat64FieldNumber),
      field(&Own::reciprocity, Message::kReciprocityFieldNumber));
};

template <>
struct Mapping<assess::Incidence> {
  using Own = assess::Incidence;
  using Message = v1::AssessIncidence;
  static constexpr auto kFields = fields<Own>(
      field(&Own::theta, Message::kThetaFieldNumber), field(&Own::phi, Message::kPhiFieldNumber),
      field(&Own::albedo, Message::kAlbedoFieldNumber),
      field(&Own::sampled, Message::kSampledFieldNumber),
      field(&Own::standard_error, Message::kStandardErrorFieldNumber),
      field(&Own::deviation, Message::kDeviationFieldNumber),
      field(&Own::mass, Message::kMassFieldNumber), field(&Own::lost, Message::kLostFieldNumber),
      field(&Own::unsure, Message::kUnsureFieldNumber),
      field(&Own::probability, Message::kProbabilityFieldNumber),
      field(&Own::weight, Message::kWeightFieldNumber));
};

template <>
struct Mapping<assess::Check> {
  using Own = assess::Check;
  using Message = v1::AssessCheck;
  static constexpr auto kFields = fields<Own>(
      field(&Own::name, Message::kNameFieldNumber), field(&Own::value, Message::kValueFieldNumber),
      field(&Own::limit, Message::kLimitFieldNumber),
      field(&Own::passed, Message::kPassedFieldNumber),
      field(&Own::where, Message::kWhereFieldNumber), field(&Own::note, Message::kNoteFieldNumber));
};

template <>
struct Mapping<assess::Assessment> {
  using Own = assess::Assessment;
  using Message = v1::AssessResponse;
  // The call adds the instruction set that it was answered with.
  static constexpr std::array kElsewhere{Message::kInstructionSetFieldNumber};
  static constexpr auto kFields =
      fields<Own>(field(&Own::passed, Message::kPassedFieldNumber),
                  field(&Own::checks, Message::kChecksFieldNumber),
                  field(&Own::places, Message::kPlacesFieldNumber),
                  field(&Own::incidences, Message::kIncidencesFieldNumber),
                  field(&Own::channels, Message::kChannelsFieldNumber),
                  field(&Own::fast, Message::kFastFieldNumber),
                  field(&Own::reference, Message::kReferenceFieldNumber),
                  field(&Own::cpu_seconds, Message::kCpuSecondsFieldNumber));
};

}  // namespace gonio::wire
