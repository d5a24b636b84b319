// The checks of single samples.
#include <cmath>

#include "models/harness/findings.h"
#include "models/harness/harness_sampling.h"
#include "models/oracle/density_oracle.h"
#include "models/oracle/run.h"
#include "models/oracle/truth.h"

namespace gonio::testing {
namespace {

constexpr std::size_t kChecked = 16;  // a whole packet of the widest

// Of float32 densities, in whose tails the roundings of an exponent count.
constexpr double kPdfError = 5e-6;

template <class T>
struct Checked {
  std::vector<DirectionPair<T>> pairs;
  Samples<T> samples;
};

// What is wrong with a number that should be `want`, `bound` its relative error.
bool differs(double got, long double want, double bound) {
  return !(std::abs(got - want) <= static_cast<long double>(bound) * want);
}

// Products of a few numbers that are right to a rounding each.
template <class T>
constexpr double kRoundings = 4 * static_cast<double>(std::numeric_limits<T>::epsilon());

template <class T>
void check_weights(const SamplingSubject<T>& subject, const Checked<T>& checked, double bound,
                   Notes& notes) {
  const auto precision = sizeof(T) == sizeof(float) ? Precision::fast : Precision::reference;
  const auto truth = truth_of(subject.spec, checked.pairs);
  const auto unsure = unsure_of(subject.spec, precision, checked.pairs, truth);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::size_t pair = i / subject.channels;
    if (!(truth[i] > kAbove) || checked.samples.flags[pair] != 0) continue;
    const std::array<T, 3>& wo = checked.pairs[pair].wo;
    const auto cosine = static_cast<long double>(wo[2]) /
                        std::hypot(static_cast<long double>(wo[0]), static_cast<long double>(wo[1]),
                                   static_cast<long double>(wo[2]));
    const long double want = static_cast<long double>(truth[i]) * cosine;
    const double got = static_cast<double>(checked.samples.weights[i]) *
                       static_cast<double>(checked.samples.pdf[pair]);
    const double allowed = bound + kRoundings<T> + (unsure.empty() ? 0 : unsure[i]);
    // A product beyond float32's normal numbers has few digits.
    if (want > 1e-30L && differs(got, want, allowed))
      notes.add("weight pdf and f cos", checked.pairs[pair], i % subject.channels, got,
                static_cast<double>(want));
  }
}

template <class T>
void check_pdfs(const SamplingSubject<T>& subject, const Checked<T>& checked, double bound,
                Notes& notes) {
  const DensityOracle oracle(subject.spec, subject.sampler);
  const auto vec = [](const std::array<T, 3>& w) { return densities::Vector{w[0], w[1], w[2]}; };
  for (std::size_t i = 0; i < checked.pairs.size(); ++i) {
    if (checked.samples.flags[i] != 0) continue;
    const auto& pair = checked.pairs[i];
    const auto got = static_cast<double>(checked.samples.pdf[i]);
    const long double want = oracle(vec(pair.wi), vec(pair.wo));
    if (want > 1e-30L && differs(got, want, bound + kRoundings<T>))
      notes.add("pdf and the papers'", pair, 0, got, static_cast<double>(want));
  }
}

template <class T>
void check_again(const SamplingSubject<T>& subject, const Checked<T>& checked, Isa isa,
                 Notes& notes) {
  const Densities<T> again = subject.evaluate(
      {checked.pairs[0].wi[0], checked.pairs[0].wi[1], checked.pairs[0].wi[2]}, checked.samples.wo);
  const std::vector<T> f = library_values<T>(subject.sampler.material(), checked.pairs, isa);
  for (std::size_t i = 0; i < checked.pairs.size(); ++i) {
    if (again.pdf[i] != checked.samples.pdf[i])
      notes.add("pdfs of sample and evaluate", checked.pairs[i], 0,
                static_cast<double>(checked.samples.pdf[i]), static_cast<double>(again.pdf[i]));
    for (std::size_t c = 0; c < subject.channels; ++c) {
      const T own = f[i * subject.channels + c], beside = again.f[i * subject.channels + c];
      if (beside != own)
        notes.add("f alone and beside the pdf", checked.pairs[i], c, static_cast<double>(own),
                  static_cast<double>(beside));
    }
  }
}

}  // namespace

template <class T>
Findings check_samples(const SamplingSubject<T>& subject, const Place& place, Isa isa) {
  Checked<T> checked{{}, subject.draw(place.wi, numbers<T>(place.seed + 2, kChecked))};
  const std::array<T, 3> wi{static_cast<T>(place.wi[0]), static_cast<T>(place.wi[1]),
                            static_cast<T>(place.wi[2])};
  for (std::size_t i = 0; i < kChecked; ++i) {
    const T* wo = &checked.samples.wo[3 * i];
    checked.pairs.push_back({wi, {wo[0], wo[1], wo[2]}, PairKind::hemisphere});
  }
  const auto precision = sizeof(T) == sizeof(float) ? Precision::fast : Precision::reference;
  const double bound = subject.sampler.material().error_bound(precision).relative;
  Notes notes;
  check_weights(subject, checked, bound, notes);
  check_pdfs(subject, checked, sizeof(T) == sizeof(float) ? kPdfError : bound, notes);
  check_again(subject, checked, isa, notes);
  return notes.findings();
}
template Findings check_samples(const SamplingSubject<float>&, const Place&, Isa);
template Findings check_samples(const SamplingSubject<double>&, const Place&, Isa);

}  // namespace gonio::testing
