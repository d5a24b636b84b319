#include "chart/machine.h"

#include <sched.h>
#include <sys/utsname.h>

#include <fstream>

#include "gonio/base/version.h"
#include "gonio/engine/isa.h"

namespace gonio::chart {
namespace {

// The value of "model name : ..." in /proc/cpuinfo.
std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t start = line.find_first_not_of(": \t", line.find(':'));
    if (start != std::string::npos) return line.substr(start);
  }
  return "unknown";
}

unsigned usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? static_cast<unsigned>(CPU_COUNT(&set)) : 0;
}

std::string system_name() {
  utsname names{};
  return ::uname(&names) == 0 ? std::string(names.sysname) + " " + names.release : "unknown";
}

std::string compiler_name() {
#ifdef __clang__
  return std::string("Clang ") + __clang_version__;
#else
  return std::string("GCC ") + __VERSION__;
#endif
}

}  // namespace

Machine this_machine() {
  Machine machine{processor_name(), usable_cores(), {}, kVersion, compiler_name(), system_name()};
  for (const Isa isa : supported_isas()) machine.instruction_sets.emplace_back(name_of(isa));
  return machine;
}

}  // namespace gonio::chart
