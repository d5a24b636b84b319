// A fit's certificate and progress on the wire. Thread safety: functions without state.
#pragma once

#include "gonio/fit/certificate.h"
#include "gonio/v1/fit.pb.h"
#include "wire/mapping/mapping.h"
#include "wire/words.h"

namespace gonio::wire {

template <>
struct Words<fit::Verdict> {
  static constexpr int kShift = 0, kLast = v1::FitVerdict_MAX;
};
static_assert(same_words<fit::Verdict, v1::FitVerdict>(
    {{fit::Verdict::converged, v1::FIT_VERDICT_CONVERGED},
     {fit::Verdict::bound_limited, v1::FIT_VERDICT_BOUND_LIMITED},
     {fit::Verdict::ambiguous, v1::FIT_VERDICT_AMBIGUOUS},
     {fit::Verdict::failed, v1::FIT_VERDICT_FAILED}},
    v1::FitVerdict_MAX, Words<fit::Verdict>::kShift));

template <>
struct Words<fit::Objective> {
  static constexpr int kShift = 1, kLast = v1::FitObjective_MAX;
};
static_assert(same_words<fit::Objective, v1::FitObjective>(
    {{fit::Objective::l1, v1::FIT_OBJECTIVE_L1},
     {fit::Objective::l2, v1::FIT_OBJECTIVE_L2},
     {fit::Objective::huber, v1::FIT_OBJECTIVE_HUBER},
     {fit::Objective::log, v1::FIT_OBJECTIVE_LOG},
     {fit::Objective::cbrt, v1::FIT_OBJECTIVE_CBRT}},
    v1::FitObjective_MAX, Words<fit::Objective>::kShift));

template <>
struct Mapping<fit::Progress> {
  using Own = fit::Progress;
  using Message = v1::FitProgress;
  static constexpr auto kFields =
      fields<Own>(field(&Own::stage, Message::kStageFieldNumber),
                  field(&Own::iteration, Message::kIterationFieldNumber),
                  field(&Own::objective, Message::kObjectiveFieldNumber),
                  field(&Own::best, Message::kBestFieldNumber));
};

template <>
struct Mapping<fit::LeftOut> {
  using Own = fit::LeftOut;
  using Message = v1::FitLeftOut;
  static constexpr auto kFields =
      fields<Own>(field(&Own::not_finite, Message::kNotFiniteFieldNumber),
                  field(&Own::not_unit, Message::kNotUnitFieldNumber),
                  field(&Own::below_horizon, Message::kBelowHorizonFieldNumber),
                  field(&Own::negative, Message::kNegativeFieldNumber),
                  field(&Own::no_weight, Message::kNoWeightFieldNumber));
};

template <>
struct Mapping<fit::Stage> {
  using Own = fit::Stage;
  using Message = v1::FitStage;
  static constexpr auto kFields =
      fields<Own>(field(&Own::name, Message::kNameFieldNumber),
                  field(&Own::objective, Message::kObjectiveFieldNumber),
                  field(&Own::pairs, Message::kPairsFieldNumber),
                  field(&Own::iterations, Message::kIterationsFieldNumber),
                  field(&Own::cpu_seconds, Message::kCpuSecondsFieldNumber));
};

template <>
struct Mapping<fit::Start> {
  using Own = fit::Start;
  using Message = v1::FitStart;
  static constexpr auto kFields = fields<Own>(
      field(&Own::given, Message::kGivenFieldNumber), field(&Own::from, Message::kFromFieldNumber),
      field(&Own::to, Message::kToFieldNumber),
      field(&Own::objective, Message::kObjectiveFieldNumber),
      field(&Own::agrees, Message::kAgreesFieldNumber));
};

template <>
struct Mapping<fit::ParameterReport> {
  using Own = fit::ParameterReport;
  using Message = v1::FitParameter;
  static constexpr auto kFields =
      fields<Own>(field(&Own::field, Message::kFieldFieldNumber),
                  field(&Own::channel, Message::kChannelFieldNumber),
                  field(&Own::value, Message::kValueFieldNumber),
                  field(&Own::standard_error, Message::kStandardErrorFieldNumber),
                  field(&Own::at_bound, Message::kAtBoundFieldNumber),
                  field(&Own::lower, Message::kLowerFieldNumber),
                  field(&Own::upper, Message::kUpperFieldNumber),
                  field(&Own::undetermined, Message::kUndeterminedFieldNumber));
};

template <>
struct Mapping<fit::Indistinct> {
  using Own = fit::Indistinct;
  using Message = v1::FitIndistinct;
  static constexpr auto kFields =
      fields<Own>(field(&Own::fields, Message::kFieldsFieldNumber),
                  field(&Own::eigenvalue, Message::kEigenvalueFieldNumber),
                  field(&Own::correlation, Message::kCorrelationFieldNumber));
};

template <>
struct Mapping<fit::Profile> {
  using Own = fit::Profile;
  using Message = v1::FitProfile;
  static constexpr auto kFields = fields<Own>(field(&Own::field, Message::kFieldFieldNumber),
                                              field(&Own::lower, Message::kLowerFieldNumber),
                                              field(&Own::upper, Message::kUpperFieldNumber),
                                              field(&Own::part, Message::kPartFieldNumber),
                                              field(&Own::separate, Message::kSeparateFieldNumber));
};

template <>
struct Mapping<fit::Errors> {
  using Own = fit::Errors;
  using Message = v1::FitErrors;
  static constexpr auto kFields = fields<Own>(
      field(&Own::l1, Message::kL1FieldNumber), field(&Own::rmse, Message::kRmseFieldNumber),
      field(&Own::log, Message::kLogFieldNumber), field(&Own::cbrt, Message::kCbrtFieldNumber),
      field(&Own::pairs, Message::kPairsFieldNumber));
};

template <>
struct Mapping<fit::ErrorsByZone> {
  using Own = fit::ErrorsByZone;
  using Message = v1::FitErrorsByZone;
  static constexpr auto kFields = fields<Own>(field(&Own::all, Message::kAllFieldNumber),
                                              field(&Own::below_80, Message::kBelow80FieldNumber),
                                              field(&Own::above_80, Message::kAbove80FieldNumber));
};

template <>
struct Mapping<fit::Place> {
  using Own = fit::Place;
  using Message = v1::FitPlace;
  static constexpr auto kFields = fields<Own>(field(&Own::wi, Message::kWiFieldNumber),
                                              field(&Own::wo, Message::kWoFieldNumber),
                                              field(&Own::channel, Message::kChannelFieldNumber),
                                              field(&Own::measured, Message::kMeasuredFieldNumber),
                                              field(&Own::fitted, Message::kFittedFieldNumber),
                                              field(&Own::share, Message::kShareFieldNumber));
};

template <>
struct Mapping<fit::Region> {
  using Own = fit::Region;
  using Message = v1::FitRegion;
  static constexpr auto kFields = fields<Own>(field(&Own::measured, Message::kMeasuredFieldNumber),
                                              field(&Own::fitted, Message::kFittedFieldNumber),
                                              field(&Own::error, Message::kErrorFieldNumber));
};

template <>
struct Mapping<fit::Regions> {
  using Own = fit::Regions;
  using Message = v1::FitRegions;
  static constexpr auto kFields =
      fields<Own>(field(&Own::mirror, Message::kMirrorFieldNumber),
                  field(&Own::toward_light, Message::kTowardLightFieldNumber),
                  field(&Own::elsewhere, Message::kElsewhereFieldNumber));
};

template <>
struct Mapping<fit::Albedo> {
  using Own = fit::Albedo;
  using Message = v1::FitAlbedo;
  static constexpr auto kFields = fields<Own>(field(&Own::theta, Message::kThetaFieldNumber),
                                              field(&Own::channels, Message::kChannelsFieldNumber));
};

template <>
struct Mapping<fit::Certificate> {
  using Own = fit::Certificate;
  using Message = v1::FitCertificate;
  static constexpr auto kFields =
      fields<Own>(field(&Own::verdict, Message::kVerdictFieldNumber),
                  field(&Own::reason, Message::kReasonFieldNumber),
                  field(&Own::objective, Message::kObjectiveFieldNumber),
                  field(&Own::pairs, Message::kPairsFieldNumber),
                  field(&Own::left_out, Message::kLeftOutFieldNumber),
                  field(&Own::shapes, Message::kShapesFieldNumber),
                  field(&Own::stages, Message::kStagesFieldNumber),
                  field(&Own::starts, Message::kStartsFieldNumber),
                  field(&Own::agreeing, Message::kAgreeingFieldNumber),
                  field(&Own::gradient_norm, Message::kGradientNormFieldNumber),
                  field(&Own::parameters, Message::kParametersFieldNumber),
                  field(&Own::active_bounds, Message::kActiveBoundsFieldNumber),
                  field(&Own::indistinct, Message::kIndistinctFieldNumber),
                  field(&Own::profiles, Message::kProfilesFieldNumber),
                  field(&Own::errors, Message::kErrorsFieldNumber),
                  field(&Own::worst, Message::kWorstFieldNumber),
                  field(&Own::regions, Message::kRegionsFieldNumber),
                  field(&Own::albedo, Message::kAlbedoFieldNumber),
                  field(&Own::cpu_seconds, Message::kCpuSecondsFieldNumber));
};

}  // namespace gonio::wire
