// How much memory a process holds, from /proc.
#pragma once

#include <unistd.h>

#include <fstream>
#include <string>

namespace gonio::bench {

// `field`: "VmRSS:" is now, "VmHWM:" the most so far. In bytes; 0 if it cannot be read.
inline double resident_bytes(pid_t process, const std::string& field) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == field && status >> kibibytes) return 1024 * kibibytes;
  }
  return 0;
}

// Lets "VmHWM:" start again from what is resident now.
inline void reset_peak(pid_t process) {
  std::ofstream("/proc/" + std::to_string(process) + "/clear_refs") << "5";
}

}  // namespace gonio::bench
