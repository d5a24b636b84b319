#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "client/cli/npy_header.h"
#include "client/cli/pair_input.h"

namespace gonio::cli {
namespace {

constexpr const char* kAllowed =
    "an array of float32 or float64 ('<f4' or '<f8'), shape (N, 6), C order";
constexpr std::size_t kColumns = 6;  // wi_x, wi_y, wi_z, wo_x, wo_y, wo_z

Error npy_error(const std::string& file, const std::string& what, const std::string& value) {
  return {ErrorCode::invalid_argument, file + ": " + what + "; allowed: " + kAllowed, "--pairs",
          value, kAllowed};
}

Result<NpyHeader> read_header(ByteSource& source) {
  const auto error = [&](const std::string& what, const std::string& value) {
    return npy_error(source.name(), what, value);
  };
  auto header = read_npy_header(source, error);
  if (header && header->columns != kColumns) {
    const std::string shape = header->shape();
    return error("has the shape " + shape, shape);
  }
  return header;
}

template <class T>
class NpyInput final : public PairInput<T> {
 public:
  NpyInput(ByteSource source, NpyHeader header) : source_(std::move(source)), header_(header) {}

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
    buffer_.resize(rows * kColumns * sizeof(Stored));
    auto got = source_.read(buffer_.data(), buffer_.size());
    if (!got) return got.error();
    if (*got < buffer_.size()) {
      const std::uint64_t whole = done_ + *got / (kColumns * sizeof(Stored));
      return npy_error(source_.name(),
                       "ends after " + std::to_string(whole) + " of the " +
                           std::to_string(header_.rows) + " rows of its header",
                       std::to_string(whole));
    }
    const char* at = buffer_.data();
    for (std::size_t row = 0; row < rows; ++row, at += kColumns * sizeof(Stored)) {
      std::array<Stored, kColumns> numbers;
      std::memcpy(numbers.data(), at, sizeof(numbers));
      for (std::size_t i = 0; i < 3; ++i) {
        wi[3 * row + i] = static_cast<T>(numbers[i]);
        wo[3 * row + i] = static_cast<T>(numbers[3 + i]);
      }
    }
    done_ += rows;
    return rows;
  }

  Result<std::size_t> check_end() {
    auto rest = source_.peek(1);
    if (!rest) return rest.error();
    if (rest->empty()) return std::size_t{0};
    return npy_error(source_.name(),
                     "goes on after the " + std::to_string(header_.rows) + " rows of its header",
                     "trailing bytes");
  }

  ByteSource source_;
  NpyHeader header_;
  std::uint64_t done_ = 0;
  std::vector<char> buffer_;
};

}  // namespace

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_npy(ByteSource source) {
  auto header = read_header(source);
  if (!header) return header.error();
  std::unique_ptr<PairInput<T>> input = std::make_unique<NpyInput<T>>(std::move(source), *header);
  return input;
}

template Result<std::unique_ptr<PairInput<float>>> open_npy(ByteSource);
template Result<std::unique_ptr<PairInput<double>>> open_npy(ByteSource);

}  // namespace gonio::cli
