// Pairs of directions, or directions wi alone, from a file: CSV or NPY, told apart by their first
// bytes. Thread safety: used by one thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/cli/input/byte_source.h"
#include "gonio/base/result.h"

namespace gonio::cli {

// What a file gives, and the argument that names it.
enum class InputKind : std::uint8_t {
  wi,     // --wi-file
  pairs,  // --pairs
};
inline const char* argument_of(InputKind what) {
  return what == InputKind::pairs ? "--pairs" : "--wi-file";
}

// T is float or double: what the evaluation takes.
template <class T>
class PairInput {
 public:
  virtual ~PairInput() = default;

  // Fills in the next pairs (interleaved xyz) as far as there are any, and returns their number.
  // `wo` is left alone where the input is of InputKind::wi. Errors name file, line, column and
  // value.
  virtual Result<std::size_t> read(std::span<T> wi, std::span<T> wo) = 0;

  // The number of pairs, where it is known beforehand.
  [[nodiscard]] virtual std::optional<std::uint64_t> total() const { return std::nullopt; }
  // How much has been read, 0 to 1, where that is known.
  [[nodiscard]] virtual std::optional<double> progress() const = 0;

  // The columns in which the input gave its pairs, and what it gave for the next pair not yet asked
  // for (angles), if it did not give the directions themselves.
  [[nodiscard]] virtual std::vector<std::string> columns() const {
    return {"wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"};
  }
  virtual std::optional<std::array<double, 4>> take_angles() { return std::nullopt; }
};

// "-" is standard input. `degrees`: angles are in degrees. `keep_angles`: take_angles() is going to
// be called.
template <class T>
Result<std::unique_ptr<PairInput<T>>> open_pairs(InputKind what, const std::string& file,
                                                 bool degrees, bool keep_angles);

// The two formats; open_pairs() chooses.
template <class T>
Result<std::unique_ptr<PairInput<T>>> open_csv(InputKind what, ByteSource source, bool degrees,
                                               bool keep_angles);
template <class T>
Result<std::unique_ptr<PairInput<T>>> open_npy(InputKind what, ByteSource source);

}  // namespace gonio::cli
