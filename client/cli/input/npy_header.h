// The header of an NPY file (format versions 1 to 3): a table of float32 or float64 in C order.
// Thread safety: functions without state.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "client/cli/input/byte_source.h"
#include "gonio/base/result.h"

namespace gonio::cli {

// What such a file begins with.
inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

struct NpyHeader {
  bool is_f64 = false;
  std::uint64_t rows = 0, columns = 0;

  [[nodiscard]] std::string shape() const {
    return "(" + std::to_string(rows) + ", " + std::to_string(columns) + ")";
  }
};

// What an error says beside `problem` ("holds numbers of type '<i4'") and `value` is the caller's:
// what would have been allowed.
using NpyError = std::function<Error(const std::string& problem, const std::string& value)>;

// Takes the header off `source`; the rows follow.
Result<NpyHeader> read_npy_header(ByteSource& source, const NpyError& error);

}  // namespace gonio::cli
