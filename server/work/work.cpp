#include "server/work/work.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/join.h"
#include "wire/convert.h"

namespace gonio::server {

Result<Isa> choose_isa(v1::InstructionSet asked) {
  if (asked == v1::INSTRUCTION_SET_UNSPECIFIED) return best_isa();
  const auto isa = wire::from_wire(asked);
  if (!isa || is_supported(*isa)) return isa;
  std::vector<std::string_view> supported;
  for (const Isa one : supported_isas()) supported.push_back(name_of(one));
  return bad_value("instruction_set", std::string(name_of(*isa)),
                   "what this server's processor has: " + joined(supported));
}

template <class Head>
Result<Settings> settings_of(const Head& head) {
  const auto precision = wire::from_wire(head.precision());
  if (!precision) return precision.error();
  const auto isa = choose_isa(head.instruction_set());
  if (!isa) return isa.error();
  return Settings{*precision, *isa};
}

template Result<Settings> settings_of(const v1::EvaluateRequest&);
template Result<Settings> settings_of(const v1::SampleRequest&);
template Result<Settings> settings_of(const v1::IntegrateRequest&);

bool Work::is_small() const {
  const bool is_ready = !needs_sampler_ || material_.has_sampler();
  return items_ == 0 || (is_ready && items_ <= kSmallValues / channels());
}

void Work::run_all() {
  for (std::size_t tile = 0; tile < tiles(); ++tile) run_tile(tile);
}

std::int64_t Work::now() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

double Work::kernel_seconds() const {
  return 1e-9 * static_cast<double>(kernel_nanoseconds_.load());
}

void Work::write(v1::Report& report) const {
  report.set_kernel_seconds(kernel_seconds());
  report.set_instruction_set(wire::to_wire(settings_.isa));
  report.set_precision(wire::to_wire(settings_.precision));
  *report.mutable_error_bound() = wire::to_wire(material().error_bound(settings_.precision));
}

}  // namespace gonio::server
