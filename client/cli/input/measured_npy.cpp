#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <utility>

#include "client/cli/input/measured_input.h"
#include "client/cli/input/npy_header.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

constexpr const char* kAllowed =
    "an array of float32 or float64 ('<f4' or '<f8'), C order, shape (N, 7) to (N, 70): wi_x, "
    "wi_y, "
    "wi_z, wo_x, wo_y, wo_z and 1 to 64 values";
constexpr std::uint64_t kPlace = 6, kMostColumns = kPlace + 64;
constexpr std::uint64_t kBlock = 4096;  // rows

template <class Stored>
void push_row(const Stored* row, std::size_t columns, MeasuredInput& input) {
  const auto narrow = [](Stored x) { return static_cast<float>(x); };
  const auto push = [&](std::size_t from, std::size_t to, std::vector<float>& numbers) {
    std::transform(row + from, row + to, std::back_inserter(numbers), narrow);
  };
  push(0, 3, input.wi);
  push(3, kPlace, input.wo);
  push(kPlace, columns, input.values);
}

template <class Stored>
Outcome read_rows(ByteSource& source, const NpyHeader& header, const NpyError& error,
                  MeasuredInput& input) {
  std::vector<Stored> block;
  for (std::uint64_t done = 0; done < header.rows;) {
    const std::uint64_t rows = std::min(kBlock, header.rows - done);
    block.resize(rows * header.columns);
    auto got = source.read(block.data(), block.size() * sizeof(Stored));
    if (!got) return got.error();
    if (*got < block.size() * sizeof(Stored)) {
      const std::string whole = std::to_string(done + *got / (header.columns * sizeof(Stored)));
      return error(
          "ends after " + whole + " of the " + std::to_string(header.rows) + " rows of its header",
          whole);
    }
    for (std::uint64_t row = 0; row < rows; ++row)
      push_row(&block[row * header.columns], header.columns, input);
    done += rows;
  }
  auto rest = source.peek(1);
  if (!rest) return rest.error();
  if (rest->empty()) return Ok{};
  return error("goes on after the " + std::to_string(header.rows) + " rows of its header",
               "trailing bytes");
}

}  // namespace

Result<MeasuredInput> read_measured_npy(ByteSource source) {
  const NpyError error = [&](const std::string& problem, const std::string& value) {
    return Error{ErrorCode::invalid_argument,
                 shown(source.name() + ": " + problem) + "; allowed: " + kAllowed, "--data",
                 shown(value), kAllowed};
  };
  const auto header = read_npy_header(source, error);
  if (!header) return header.error();
  if (header->columns <= kPlace || header->columns > kMostColumns)
    return error("has the shape " + header->shape(), header->shape());
  MeasuredInput input;
  input.channels = static_cast<int>(header->columns - kPlace);
  const Outcome read = header->is_f64 ? read_rows<double>(source, *header, error, input)
                                      : read_rows<float>(source, *header, error, input);
  if (!read) return read.error();
  return input;
}

}  // namespace gonio::cli
