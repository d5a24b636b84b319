#include "models/harness/harness.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "engine/material/derivative.h"
#include "gonio/engine/registry.h"
#include "models/harness/findings.h"
#include "models/oracle/run.h"
#include "models/oracle/truth.h"

namespace gonio::testing {
namespace {

void check_parameter(const Parameter& p, Notes& notes) {
  const std::string name(p.name);
  if (!std::regex_match(name, std::regex("[a-z][a-z0-9_]*"))) notes.add(name + ": not a name");
  if (p.meaning.empty()) notes.add(name + ": no meaning");
  if (p.unit != "1" && p.unit != "rad") notes.add(name + ": unit " + std::string(p.unit));
  if (p.type == ParameterType::word) {
    if (p.words.empty()) notes.add(name + ": no words");
    if (std::set(p.words.begin(), p.words.end()).size() != p.words.size())
      notes.add(name + ": a word twice");
    return;
  }
  if (!p.words.empty()) notes.add(name + ": a number with words");
  if (!(std::isfinite(p.lower) && std::isfinite(p.upper) && p.lower < p.upper))
    notes.add(name + ": no range");
  if (!(p.lower <= p.start && p.start <= p.upper)) notes.add(name + ": starts outside its bounds");
  // A fit starts there: a logarithm must exist.
  if (p.scale == Scale::logarithmic && !(p.start > 0)) notes.add(name + ": starts at log 0");
}

std::vector<DirectionPair<double>> widened(const std::vector<DirectionPair<float>>& pairs) {
  std::vector<DirectionPair<double>> wide;
  for (const auto& p : pairs) {
    wide.push_back({{p.wi[0], p.wi[1], p.wi[2]}, {p.wo[0], p.wo[1], p.wo[2]}, p.kind});
  }
  return wide;
}

// Whether two values that should be one are, within `relative` of the larger.
bool agree(double a, double b, double relative, double above) {
  const double larger = std::max(a, b);
  return std::isfinite(a) && std::isfinite(b) &&
         (larger <= above || larger - std::min(a, b) <= relative * larger);
}

// How nearly two values agree, with both cosines above `cosine` and values above `above`.
struct Tolerance {
  double relative, cosine, above = kAbove;
};

template <class T>
void expect_equal(const Draw& draw, const std::vector<DirectionPair<T>>& pairs, const auto& some,
                  const auto& others, const Tolerance& tolerance, Notes& notes) {
  const std::size_t channels = some.size() / pairs.size();
  for (std::size_t i = 0; i < some.size() && !notes.full(); ++i) {
    const auto& pair = pairs[i / channels];
    if (std::min(pair.wi[2], pair.wo[2]) < static_cast<T>(tolerance.cosine)) continue;
    const auto a = static_cast<double>(some[i]), b = static_cast<double>(others[i]);
    if (!agree(a, b, tolerance.relative, tolerance.above))
      notes.add(draw.name, pair, i % channels, a, b);
  }
}

// The same roughness or exponent along both tangents.
Draw made_isotropic(Draw draw) {
  LobeSpec& lobe = *draw.spec.model;
  const ModelDescription& model = **find_model(lobe.model);
  if (!model.has_tangents()) return draw;
  const auto along_u = lobe.parameters.find(model.along_tangents[0]);
  if (along_u != lobe.parameters.end())
    lobe.parameters[std::string(model.along_tangents[1])] = along_u->second;
  return draw;
}

// Turned about the normal by the angle of this cosine and sine.
template <class T>
std::vector<DirectionPair<T>> turned(std::vector<DirectionPair<T>> pairs, double c, double s) {
  for (auto& pair : pairs) {
    for (auto* w : {&pair.wi, &pair.wo}) {
      const auto x = static_cast<double>((*w)[0]), y = static_cast<double>((*w)[1]);
      (*w)[0] = static_cast<T>(c * x - s * y);
      (*w)[1] = static_cast<T>(s * x + c * y);
    }
  }
  return pairs;
}

template <class T>
std::vector<DirectionPair<T>> exchanged(std::vector<DirectionPair<T>> pairs) {
  for (auto& pair : pairs) std::swap(pair.wi, pair.wo);
  return pairs;
}

}  // namespace

std::vector<double> library_derivative(const MaterialSpec& spec, const std::string& by,
                                       const std::vector<DirectionPair<double>>& pairs, Isa isa) {
  const auto derivative = MaterialDerivative::create(spec, by);
  if (!derivative) throw std::invalid_argument(derivative.error().message);
  return batch_values<double>(derivative->channels(), pairs,
                              [&](const auto& batch) { derivative->evaluate(batch, isa); });
}

Subject library_subject(std::string_view model) {
  return {**find_model(model),
          [](const auto& spec, const auto& pairs, Isa isa) {
            return library_values<float>(material_of(spec), pairs, isa);
          },
          [](const auto& spec, const auto& pairs, Isa isa) {
            return library_values<double>(material_of(spec), pairs, isa);
          },
          [](const auto& spec, const std::string& by, const auto& pairs, Isa isa) {
            return library_derivative(spec, "parameters." + by, pairs, isa);
          }};
}

Findings check_description(const Subject& subject) {
  const ModelDescription& model = subject.description;
  Notes notes;
  if (!std::regex_match(std::string(model.name), std::regex("[a-z][a-z0-9_]*")))
    notes.add("not a name");
  if (model.summary.empty()) notes.add("no summary");
  if (!std::regex_match(std::string(model.source), std::regex(".*[12][0-9]{3}.*")))
    notes.add("no source with a year");
  for (const ErrorBound& bound : {model.fast, model.reference}) {
    if (!(bound.relative > 0 && bound.relative <= 1e-5 && bound.above <= kAbove))
      notes.add("no error bound worth the name");
  }
  if (!(model.reference.relative < model.fast.relative)) notes.add("reference no better than fast");
  if (model.role != Role::measured && !(model.albedo_limit >= 1)) notes.add("no albedo limit");
  std::set<std::string_view> names;
  for (const Parameter& p : model.parameters) {
    if (!names.insert(p.name).second) notes.add(std::string(p.name) + ": twice");
    check_parameter(p, notes);
  }
  return notes.findings();
}

Findings check_reciprocity(const Subject& subject) {
  const auto pairs = some_hard_pairs<float>(11, 3000);
  const auto back = exchanged(pairs);
  const auto wide = widened(pairs), wide_back = exchanged(wide);
  const auto tolerance = [](const ErrorBound& bound) {
    return Tolerance{2 * bound.relative, 1.001 * bound.cosine};
  };
  Notes notes;
  for (const Draw& draw : draws_of(subject.description)) {
    if (notes.full()) break;
    for (const Isa isa : supported_isas()) {
      expect_equal(draw, pairs, subject.fast(draw.spec, pairs, isa),
                   subject.fast(draw.spec, back, isa), tolerance(subject.description.fast), notes);
      expect_equal(draw, wide, subject.reference(draw.spec, wide, isa),
                   subject.reference(draw.spec, wide_back, isa),
                   tolerance(subject.description.reference), notes);
    }
  }
  return notes.findings();
}

Findings check_rotation(const Subject& subject) {
  const auto floats = some_hard_pairs<float>(12, 1500);
  const auto doubles = some_hard_pairs<double>(13, 1500);
  const auto quarter = turned(floats, 0, 1);  // exact
  const auto any = turned(doubles, std::cos(0.7), std::sin(0.7));
  // The turned directions are rounded again, which sharp lobes magnify, and roots near 0.
  const Tolerance of_any{1e-6, 1e-3, 1e-3};
  const Tolerance of_quarter{2 * subject.description.fast.relative, 2e-6};
  Notes notes;
  for (const Draw& drawn : draws_of(subject.description)) {
    if (notes.full()) break;
    const Draw draw = made_isotropic(drawn);
    for (const Isa isa : supported_isas()) {
      expect_equal(draw, floats, subject.fast(draw.spec, floats, isa),
                   subject.fast(draw.spec, quarter, isa), of_quarter, notes);
    }
    expect_equal(draw, doubles, subject.reference(draw.spec, doubles, best_isa()),
                 subject.reference(draw.spec, any, best_isa()), of_any, notes);
  }
  return notes.findings();
}

Findings check_proper(const Subject& subject, std::size_t evaluations) {
  const ModelDescription& model = subject.description;
  Notes notes;
  std::size_t done = 0;
  for (std::uint64_t seed = 100; done < evaluations && !notes.full(); ++seed) {
    const auto pairs = hard_pairs<float>(seed);
    const auto wide = widened(pairs);
    for (const Draw& draw : draws_of(model)) {
      if (notes.full()) break;
      // Where f crosses 0, neither can say much about small values.
      const bool crosses = !delicate_parameters(draw.spec).empty();
      for (const Isa isa : supported_isas()) {
        const auto fast = subject.fast(draw.spec, pairs, isa);
        const auto reference = subject.reference(draw.spec, wide, isa);
        const std::size_t channels = fast.size() / pairs.size();
        for (std::size_t i = 0; i < fast.size() && !notes.full(); ++i) {
          const auto& pair = pairs[i / channels];
          const auto a = static_cast<double>(fast[i]), b = reference[i];
          const bool proper = std::isfinite(a) && std::isfinite(b) && !(a < 0) && !(b < 0);
          const bool near_horizon = std::min(pair.wi[2], pair.wo[2]) < 1.001e-6F;
          const bool settled = near_horizon || b > 1e37 || (crosses && b < 1e-2);
          const double allowed = model.fast.relative + model.reference.relative;
          if (!proper || (!settled && !agree(a, b, allowed, 1.001 * kAbove)))
            notes.add(draw.name, pair, i % channels, a, b);
        }
        done += 2 * pairs.size();
      }
    }
  }
  return notes.findings();
}

}  // namespace gonio::testing
