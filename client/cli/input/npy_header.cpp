#include "client/cli/input/npy_header.h"

#include <array>
#include <charconv>
#include <regex>

namespace gonio::cli {
namespace {

// A usual one has about a hundred bytes. std::regex recurses for every character: tens of
// thousands of them are more than a stack holds.
constexpr std::size_t kLongestHeader = 4096;

// The header's text, a Python dictionary.
Result<std::string> read_text(ByteSource& source, const NpyError& error) {
  std::array<unsigned char, 12> start{};
  auto got = source.read(start.data(), 8);
  if (!got) return got.error();
  const int version = start[6];
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  if (*got == 8 && (version < 1 || version > 3)) {
    return error("is NPY version " + std::to_string(version) + ", not 1 to 3",
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
  if (*got < text.size() || length == 0)
    return error("ends within its header, or is no NPY file", "truncated");
  return text;
}

std::string find(const std::string& text, const char* pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : std::string();
}

bool parse(const std::string& text, std::uint64_t& number) {
  const auto [at, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  return !text.empty() && problem == std::errc{};
}

}  // namespace

Result<NpyHeader> read_npy_header(ByteSource& source, const NpyError& error) {
  auto text = read_text(source, error);
  if (!text) return text.error();
  const std::string type = find(*text, R"('descr'\s*:\s*'([^']*)')");
  const std::string order = find(*text, R"('fortran_order'\s*:\s*(True|False))");
  const std::string shape = find(*text, R"('shape'\s*:\s*(\([^)]*\)))");
  const std::string rows = find(shape, R"(^\(\s*(\d+)L?\s*,\s*\d+L?\s*,?\s*\)$)");
  const std::string columns = find(shape, R"(^\(\s*\d+L?\s*,\s*(\d+)L?\s*,?\s*\)$)");
  if (type != "<f4" && type != "<f8") return error("holds numbers of type '" + type + "'", type);
  if (order != "False") return error("is in Fortran order", "Fortran order");
  NpyHeader header{type == "<f8", 0, 0};
  if (!parse(rows, header.rows) || !parse(columns, header.columns))
    return error("has the shape " + shape, shape);
  return header;
}

}  // namespace gonio::cli
