#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <regex>
#include <utility>

#include "client/cli/pair_input.h"

namespace gonio::cli {
namespace {

// wi_x, wi_y, wi_z, and for pairs wo_x, wo_y, wo_z.
std::size_t columns_of(InputKind what) { return what == InputKind::pairs ? 6 : 3; }

// A usual one has about a hundred bytes. std::regex recurses for every character: tens of
// thousands of them are more than a stack holds.
constexpr std::size_t kLongestHeader = 4096;

struct Header {
  bool is_f64 = false;
  std::uint64_t rows = 0;
};

// An NPY file on its way in: errors need the name and what is wanted of it.
struct File {
  ByteSource source;
  InputKind what;

  [[nodiscard]] Error error(const std::string& problem, const std::string& value) const {
    const std::string allowed = "an array of float32 or float64 ('<f4' or '<f8'), shape (N, " +
                                std::to_string(columns_of(what)) + "), C order";
    return {ErrorCode::invalid_argument, source.name() + ": " + problem + "; allowed: " + allowed,
            argument_of(what), value, allowed};
  }
};

// The header's text, a Python dictionary (format versions 1 to 3).
Result<std::string> read_header_text(File& file) {
  ByteSource& source = file.source;
  std::array<unsigned char, 12> start{};
  auto got = source.read(start.data(), 8);
  if (!got) return got.error();
  const int version = start[6];
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  if (*got == 8 && (version < 1 || version > 3)) {
    return file.error("is NPY version " + std::to_string(version) + ", not 1 to 3",
                      std::to_string(version));
  }
  got = source.read(&start[8], length_bytes);
  if (!got) return got.error();
  std::size_t length = 0;
  for (std::size_t i = length_bytes; i-- > 0;) length = length << 8 | start[8 + i];
  if (length > kLongestHeader) {
    return bad_value(source.name() + ": the length of its NPY header", std::to_string(length),
                     "at most " + std::to_string(kLongestHeader) + " bytes");
  }
  std::string text(length, '\0');
  got = source.read(text.data(), text.size());
  if (!got) return got.error();
  if (*got < text.size() || length == 0) {
    return file.error("ends within its header, or is no NPY file", "truncated");
  }
  return text;
}

std::string find(const std::string& text, const char* pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

Result<Header> read_header(File& file) {
  auto text = read_header_text(file);
  if (!text) return text.error();
  const std::string type = find(*text, R"('descr'\s*:\s*'([^']*)')");
  const std::string order = find(*text, R"('fortran_order'\s*:\s*(True|False))");
  const std::string shape = find(*text, R"('shape'\s*:\s*(\([^)]*\)))");
  const std::string columns = std::to_string(columns_of(file.what));
  const std::string rows =
      find(shape, (R"(^\(\s*(\d+)L?\s*,\s*)" + columns + R"(L?\s*,?\s*\)$)").c_str());
  if (type != "<f4" && type != "<f8") {
    return file.error("holds numbers of type '" + type + "'", type);
  }
  if (order != "False") return file.error("is in Fortran order", "Fortran order");
  Header header{type == "<f8", 0};
  const auto [at, error] = std::from_chars(rows.data(), rows.data() + rows.size(), header.rows);
  if (rows.empty() || error != std::errc{}) {
    return file.error("has the shape " + shape, shape);
  }
  return header;
}

template <class T>
class NpyInput final : public PairInput<T> {
 public:
  NpyInput(File file, Header header)
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
  Header header_;
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
