// Evaluation with the densities of a sampler.
#include <cassert>

#include "engine/material/flush_to_zero.h"
#include "engine/sampling/sampling_run.h"

namespace gonio {
namespace {

using sampling::for_flagged;
using sampling::padded_to;
using sampling::Run;
using sampling::run_length;
using sampling::Scratch;

template <class In, class Out>
std::uint8_t evaluate_all(const Sampler& sampler, const Batch<In, Out>& batch, Out* pdf, Isa isa) {
  assert(is_supported(isa));
  const FlushToZero flush;
  const KernelTable& table = kernels(isa);
  Scratch<In, Out> scratch;
  std::uint8_t any = 0;
  for (std::size_t begin = 0, n = 0; begin < batch.count; begin += n) {
    n = std::min(run_length(sampler, batch.count), batch.count - begin);
    const std::size_t padded = padded_to(table, n);
    Run<In, Out> run(sampler, isa, padded, scratch);
    KernelInput<In> in{{}, {}, padded};
    lay_out(advanced(batch.wi, begin), n, padded, table, scratch.wi, in.wi);
    lay_out(advanced(batch.wo, begin), n, padded, table, scratch.wo, in.wo);
    run.share(in.wi, nullptr, nullptr);
    run.evaluate(in);
    for_flagged(scratch.flags, n, [&](std::size_t i) {
      any = static_cast<std::uint8_t>(any | scratch.flags[i]);
      if ((scratch.flags[i] & ~flag::hole) != 0) run.clear(i);
    });
    copy_values(scratch.values, padded, sampler.material().channels(), n, table, batch.values,
                begin);
    std::copy_n(scratch.pdf, n, pdf + begin);
    if (batch.flags != nullptr) std::copy_n(scratch.flags, n, batch.flags + begin);
  }
  return any;
}

}  // namespace

std::uint8_t evaluate(const Sampler& s, const Batch<float, float>& b, float* pdf, Isa isa) {
  return evaluate_all(s, b, pdf, isa);
}
std::uint8_t evaluate(const Sampler& s, const Batch<float, double>& b, double* pdf, Isa isa) {
  return evaluate_all(s, b, pdf, isa);
}
std::uint8_t evaluate(const Sampler& s, const Batch<double, double>& b, double* pdf, Isa isa) {
  return evaluate_all(s, b, pdf, isa);
}

}  // namespace gonio
