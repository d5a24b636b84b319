// The directions wi that `gonio sample` and `gonio albedo` are given: one on the command line, or
// those of a file. Thread safety: used by one thread.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "client/cli/input/pair_input.h"
#include "gonio/base/result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
}

namespace gonio::cli {

// For a command's footer: what --wi-file takes.
extern const char* const kWiHelp;

struct WiArguments {
  std::string wi;       // "X,Y,Z"
  std::string wi_file;  // in place of it; "-" is stdin
  bool degrees = false;
};

// Adds --wi, --wi-file and --deg.
void add_wi_options(CLI::App& command, WiArguments& arguments);

// "X,Y,Z", a direction to the light. Errors: what is not one, with the reason.
Result<std::array<double, 3>> parse_wi(const std::string& text);

// T is float or double.
template <class T>
class WiInput {
 public:
  // Errors: neither or both given, a --wi that cannot be, a file that cannot be read.
  static Result<WiInput> open(const WiArguments& arguments);

  // The next of them (interleaved xyz), and their number; 0 at the end.
  Result<std::size_t> read(std::span<T> wi);
  // How many there are, where that is known beforehand; how much has been read, likewise.
  [[nodiscard]] std::optional<std::uint64_t> total() const;
  [[nodiscard]] std::optional<double> progress() const;

 private:
  std::optional<std::array<double, 3>> single_;  // not yet read
  std::unique_ptr<PairInput<T>> file_;
};

}  // namespace gonio::cli
