#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "client/cli/input/npy_header.h"
#include "client/cli/input/pair_input.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

// wi_x, wi_y, wi_z, and for pairs wo_x, wo_y, wo_z.
std::size_t columns_of(InputKind what) { return what == InputKind::pairs ? 6 : 3; }

// An NPY file on its way in: errors need the name and what is wanted of it.
struct File {
  ByteSource source;
  InputKind what;

  [[nodiscard]] Error error(const std::string& problem, const std::string& value) const {
    const std::string allowed = "an array of float32 or float64 ('<f4' or '<f8'), shape (N, " +
                                std::to_string(columns_of(what)) + "), C order";
    return {ErrorCode::invalid_argument,
            shown(source.name() + ": " + problem) + "; allowed: " + allowed, argument_of(what),
            shown(value), allowed};
  }
};

Result<NpyHeader> read_header(File& file) {
  const auto error = [&](const std::string& problem, const std::string& value) {
    return file.error(problem, value);
  };
  auto header = read_npy_header(file.source, error);
  if (header && header->columns != columns_of(file.what))
    return error("has the shape " + header->shape(), header->shape());
  return header;
}

template <class T>
class NpyInput final : public PairInput<T> {
 public:
  NpyInput(File file, NpyHeader header)
      : file_(std::move(file)), header_(header), columns_(columns_of(file_.what)) {}

  Result<std::size_t> read(std::span<T> wi, std::span<T> wo) override {
    return header_.is_f64 ? read_rows<double>(wi, wo) : read_rows<float>(wi, wo);
  }

  [[nodiscard]] std::optional<std::uint64_t> total() const override { return header_.rows; }
  [[nodiscard]] std::optional<double> progress() const override {
    if (header_.rows == 0) return std::nullopt;
    return static_cast<double>(done_) / static_cast<double>(header_.rows);
  }

 private:
  template <class Stored>
  Result<std::size_t> read_rows(std::span<T> wi, std::span<T> wo) {
    const std::size_t rows = std::min<std::uint64_t>(wi.size() / 3, header_.rows - done_);
    if (rows == 0) return check_end();
    buffer_.resize(rows * columns_ * sizeof(Stored));
    auto got = file_.source.read(buffer_.data(), buffer_.size());
    if (!got) return got.error();
    if (*got < buffer_.size()) {
      const std::uint64_t whole = done_ + *got / (columns_ * sizeof(Stored));
      return file_.error("ends after " + std::to_string(whole) + " of the " +
                             std::to_string(header_.rows) + " rows of its header",
                         std::to_string(whole));
    }
    const char* at = buffer_.data();
    for (std::size_t row = 0; row < rows; ++row, at += columns_ * sizeof(Stored)) {
      std::array<Stored, 6> numbers;
      std::memcpy(numbers.data(), at, columns_ * sizeof(Stored));
      for (std::size_t i = 0; i < 3; ++i) wi[3 * row + i] = static_cast<T>(numbers[i]);
      if (file_.what == InputKind::wi) continue;
      for (std::size_t i = 0; i < 3; ++i) wo[3 * row + i] = static_cast<T>(numbers[3 + i]);
    }
    done_ += rows;
    return rows;
  }

  Result<std::size_t> check_end() {
    auto rest = file_.source.peek(1);
    if (!rest) return rest.error();
    if (rest->empty()) return std::size_t{0};
    return file_.error("goes on after the " + std::to_string(header_.rows) + " rows of its header",
                       "trailing bytes");
  }

  File file_;
  NpyHeader header_;
  std::size_t columns_;
  std::uint64_t done_ = 0;
  std::vector<char> buffer_;
};

}  // namespace

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_npy(InputKind what, ByteSource source) {
  File file{std::move(source), what};
  auto header = read_header(file);
  if (!header) return header.error();
  std::unique_ptr<PairInput<T>> input = std::make_unique<NpyInput<T>>(std::move(file), *header);
  return input;
}

template Result<std::unique_ptr<PairInput<float>>> open_npy(InputKind, ByteSource);
template Result<std::unique_ptr<PairInput<double>>> open_npy(InputKind, ByteSource);

}  // namespace gonio::cli
