// The result of a selection: every material that was tried, and the one that is chosen. The
// selection, the wire (proto/wire/mapping/selection.h) and the client library use these structures,
// each with its own kind of material. Thread safety: plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gonio::select {

struct Progress {
  std::string stage;               // "queued", "reference", "candidates"
  std::string candidate = {};      // the one that is being fitted
  std::uint64_t done = 0, of = 0;  // candidates
};

// An error by the scene's metric, with its one-sided bounds.
struct Bounded {
  double value = 0, lower = 0, upper = 0;
};

template <class Material>
struct EntryOf {
  std::string name;                  // "lambertian + 2 ggx:schlick"; "reference": itself
  std::optional<Material> material;  // as fitted; none for the reference itself
  std::uint64_t parameters = 0;      // count of numbers that the fit chose
  double ns = 0;                     // nanoseconds of an evaluation in float32
  std::uint64_t bytes = 0;
  double second_moment = 0;  // relative, of a sample's weight; only where it is part of the cost
  double cost = 0;           // by the scene's kind
  Bounded error;             // on pairs that it was not fitted to; bounds of 95 % each
  std::vector<std::string> at_bounds;  // fields of parameters that a bound holds
  bool on_front = false;               // errs less than all cheaper ones by more than chance
  bool meets = false;                  // its error's bound is below the tolerance
  std::string remark;                  // why it is not on the front, or not chosen
};

template <class Material>
struct ChoiceOf {
  std::uint64_t entry = 0;           // an index of the entries
  std::optional<Material> material;  // its numbers rounded; none for the reference itself
  unsigned digits = 0;               // significant decimals; 0: rounded numbers miss the tolerance
  bool needs_float64 = false;        // float32 would miss the tolerance
  double float32_error = 0;          // the largest error that float32 adds, by the metric
  Bounded error;                     // certified on pairs that had no part in the choice
  double confidence = 0;             // of its bounds
  std::uint64_t pairs = 0;           // pairs that certified it
};

template <class Material>
struct SelectionOf {
  std::vector<EntryOf<Material>> entries;    // by cost
  std::optional<ChoiceOf<Material>> choice;  // none: nothing is good enough
  std::string reason;
};

}  // namespace gonio::select
