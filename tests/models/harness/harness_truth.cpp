// The checks that hold a model against the oracle.
#include <algorithm>

#include "models/harness/compare.h"
#include "models/harness/findings.h"
#include "models/harness/harness.h"
#include "models/oracle/truth.h"

namespace gonio::testing {
namespace {

template <class T>
void hold(const Draw& draw, const std::vector<DirectionPair<T>>& pairs, const auto& got,
          Precision precision, double bound, Notes& notes) {
  using Out = std::remove_cvref_t<decltype(got[0])>;
  const std::vector<Quad> truth = truth_of(draw.spec, pairs);
  const auto unsure = unsure_of(draw.spec, precision, pairs, truth);
  const Comparison result = compare<Out>(got, truth, kAbove, unsure);
  const std::size_t channels = got.size() / pairs.size();
  const auto note = [&](const std::string& what, std::size_t at) {
    notes.add(draw.name + ", " + what, pairs[at / channels], at % channels,
              static_cast<double>(got[at]), static_cast<double>(truth[at]));
  };
  if (result.improper_at) note(result.improper, *result.improper_at);
  if (result.worst > bound) note("error " + std::to_string(result.worst), result.worst_at);
}

// f of the oracle with one parameter of all channels moved by `step` of its size.
struct Moved {
  std::vector<Quad> f;
  std::vector<double> by;  // the parameter's change, channel by channel
};

constexpr double kSmallest = 1e-3;  // what a step is relative to where a parameter is 0

Moved moved(const MaterialSpec& spec, const std::string& name, double step,
            const std::vector<DirectionPair<double>>& pairs) {
  MaterialSpec changed = spec;
  auto& values = std::get<std::vector<double>>(changed.model->parameters.at(name));
  Moved result;
  for (double& v : values) {
    const double before = v;
    v += step * std::max(std::abs(v), kSmallest);
    result.by.push_back(v - before);
  }
  result.f = oracle_values(Oracle<Quad>(changed), pairs);
  return result;
}

// The derivative from the left and from the right.
struct Sides {
  double left, right;

  // Right where the formula is smooth, anything between the sides at a corner.
  [[nodiscard]] bool allow(double derivative, double size) const {
    const double low = std::min(left, right), high = std::max(left, right);
    const double middle = (low + high) / 2, slack = 1e-6 * (std::abs(middle) + size);
    if (std::abs(derivative - middle) <= slack) return true;
    const bool corner = high - low > 1e-4 * (std::abs(low) + std::abs(high) + size);
    return corner && derivative >= low - slack && derivative <= high + slack;
  }
};

struct Sampled {
  std::vector<DirectionPair<double>> pairs;
  std::vector<Quad> f;
};

void check_one(const Subject& subject, const Draw& draw, const std::string& name,
               const Sampled& sampled, Notes& notes) {
  constexpr double kStep = 1e-7;
  const auto& [pairs, f] = sampled;
  const Moved up = moved(draw.spec, name, kStep, pairs);
  const Moved down = moved(draw.spec, name, -kStep, pairs);
  const auto& values = std::get<std::vector<double>>(draw.spec.model->parameters.at(name));
  const std::size_t channels = f.size() / pairs.size();
  for (const Isa isa : supported_isas()) {
    const auto got = subject.derivative(draw.spec, name, pairs, isa);
    for (std::size_t i = 0; i < f.size() && !notes.full(); ++i) {
      const std::size_t channel = i % channels, own = values.size() == 1 ? 0 : channel;
      const double right = static_cast<double>((up.f[i] - f[i]) / up.by[own]);
      const double left = static_cast<double>((down.f[i] - f[i]) / down.by[own]);
      // f may jump with a parameter (0^s at s = 0): then there is none to compare with.
      const auto jumps = [&](const Quad& other) {
        const auto change = static_cast<double>(other - f[i]);
        return std::abs(change) > 0.1 * static_cast<double>(f[i]);
      };
      const double size = static_cast<double>(f[i]) / std::max(std::abs(values[own]), kSmallest);
      // Beyond a bound the formula may have no value.
      const Sides sides{std::isfinite(left) ? left : right, std::isfinite(right) ? right : left};
      const bool smooth = f[i] > kAbove && !jumps(up.f[i]) && !jumps(down.f[i]);
      if (!std::isfinite(got[i]) || (smooth && !sides.allow(got[i], size)))
        notes.add("d/d" + name + ", " + draw.name, pairs[i / channels], channel, got[i],
                  (sides.left + sides.right) / 2);
    }
  }
}

}  // namespace

Findings check_accuracy(const Subject& subject) {
  Notes notes;
  std::uint64_t seed = 50;
  for (const Draw& draw : draws_of(subject.description)) {
    if (notes.full()) break;
    const auto floats = some_hard_pairs<float>(++seed, 250, 0);
    const auto doubles = some_hard_pairs<double>(++seed, 250, 0);
    for (const Isa isa : supported_isas()) {
      hold(draw, floats, subject.fast(draw.spec, floats, isa), Precision::fast,
           subject.description.fast.relative, notes);
      hold(draw, doubles, subject.reference(draw.spec, doubles, isa), Precision::reference,
           subject.description.reference.relative, notes);
    }
  }
  return notes.findings();
}

Findings check_derivatives(const Subject& subject) {
  Notes notes;
  std::uint64_t seed = 500;
  for (const Draw& draw : draws_of(subject.description)) {
    if (notes.full()) break;
    Sampled sampled{some_hard_pairs<double>(++seed, 80, 1e-3), {}};
    sampled.f = oracle_values(Oracle<Quad>(draw.spec), sampled.pairs);
    for (const Parameter& p : subject.description.parameters) {
      const std::string name(p.name);
      if (p.type == ParameterType::word || !draw.spec.model->parameters.contains(name)) continue;
      check_one(subject, draw, name, sampled, notes);
    }
  }
  return notes.findings();
}

}  // namespace gonio::testing
