#include "assess/assess.h"

#include <algorithm>
#include <ctime>

#include "assess/accuracy.h"
#include "assess/energy.h"
#include "assess/places.h"
#include "assess/samples.h"
#include "assess/verdict.h"

namespace gonio::assess {
namespace {

// CPU time of the calling thread, in seconds.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Result<Report> assess(const Subject& subject, const Options& options,
                      const std::function<bool()>& stop) {
  if (auto checked = check_options(options); !checked) return checked.error();
  const double start = cpu_seconds();
  const auto is_over = [&stop] { return stop && stop(); };
  Report report;
  report.channels = subject.channels;
  report.fast = stated(subject.fast), report.reference = stated(subject.reference);
  for (std::size_t place = 0; place < places().size() && !is_over(); ++place) {
    auto found = look_at(place, subject, options.pairs, options.seed, stop);
    if (found) report.places.push_back(*found);
  }
  for (const Angles& angles : incidences_of(subject, options.seed)) {
    if (is_over()) break;
    const Energy energy = integrate_from(angles, subject, stop);
    if (is_over()) break;
    report.incidences.push_back(sample_from(energy, subject, options.seed));
  }
  if (subject.table && !is_over()) report.table = review(*subject.table);
  if (is_over()) return Error{ErrorCode::cancelled, "the assessment was cancelled", {}, {}, {}};
  set_verdict(options.limits, report);
  report.cpu_seconds = cpu_seconds() - start;
  return report;
}

Result<Report> assess(const Sampler& sampler, const Options& options, Isa isa,
                      const std::function<bool()>& stop) {
  return assess(subject_of(sampler, isa), options, stop);
}

std::size_t memory_of(int channels, const Options& options) {
  constexpr std::size_t kChunk = 2048, kQuadrature = std::size_t{24} << 20U;
  const auto values = static_cast<std::size_t>(channels) * std::min(kChunk, options.pairs);
  return kQuadrature + values * 16 * sizeof(double);
}

}  // namespace gonio::assess
