#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "base/text/encoding.h"
#include "base/text/lines.h"
#include "base/text/number.h"
#include "gonio/base/shown.h"
#include "measured/file_error.h"
#include "measured/pairs.h"
#include "measured/text_file.h"

namespace gonio {
namespace {

constexpr int kMostValues = 64;
constexpr std::size_t kAngles = 3;  // of a row, before its values
constexpr std::string_view kBlanks = " \t";

struct Header {
  int values = 0;  // of a row
  bool cosine = false;
};

// What follows a word such as #DIM on a line of its own.
struct Entry {
  std::string_view word, text;  // no text: the file has no such line, or none behind the word
  std::size_t line = 1;

  [[nodiscard]] Error error(const std::string& name, const std::string& expected) const {
    const std::string found =
        text.empty() ? "no " + std::string(word) : std::string(word) + " " + std::string(text);
    return file_error(ErrorCode::data_loss, name + ":" + std::to_string(line),
                      shown(found, kQuotedLength), expected);
  }
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Errors: the word twice, with different texts.
Result<Entry> entry(std::string_view text, std::string_view word, const std::string& name) {
  Entry found{word, {}, 1};
  LineReader lines(text);
  while (auto line = lines.next()) {
    if (line->substr(0, word.size()) != word) continue;
    line->remove_prefix(word.size());
    if (!line->empty() && kBlanks.find(line->front()) == std::string_view::npos) continue;
    const Entry another{word, trimmed(*line), lines.number()};
    if (!found.text.empty() && another.text != found.text)
      return another.error(name, "the same as on line " + std::to_string(found.line));
    if (found.text.empty()) found = another;
  }
  return found;
}

// "3 N" with N from 1 to 64; none if it is something else.
std::optional<int> values_of(std::string_view dimensions) {
  const std::size_t blank = dimensions.find_first_of(kBlanks);
  if (blank == std::string_view::npos) return std::nullopt;
  const auto from = parse_number<double>(dimensions.substr(0, blank));
  const auto to = parse_number<double>(trimmed(dimensions.substr(blank)));
  if (!from || *from != 3 || !to || !(*to >= 1 && *to <= kMostValues) || *to != std::floor(*to))
    return std::nullopt;
  return static_cast<int>(*to);
}

Result<Header> read_header(std::string_view text, const std::string& name) {
  std::array<Entry, 4> entries;
  constexpr std::array<std::string_view, 4> kWords{"#DIM", "#PARAM_IN", "#VS", "#PARAM_OUT"};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto found = entry(text, kWords[i], name);
    if (!found) return found.error();
    entries[i] = *found;
  }
  const auto& [dimensions, in, vertical, out] = entries;
  const auto values = values_of(dimensions.text);
  if (!values) {
    return dimensions.error(name,
                            "#DIM 3 and the number of values, 1 to " + std::to_string(kMostValues));
  }
  if (in.text != "ISOTROPIC_TL_TV_PROJ_DPHI")
    return in.error(name, "#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI");
  if (!vertical.text.empty() && vertical.text != "0")
    return vertical.error(name, "#VS 0: values without intervals");
  const bool cosine = out.text == "INV_STERADIAN_COSINE_FACTOR";
  if (!cosine && !out.text.empty() && out.text != "INV_STERADIAN" && out.text != "RGB_COLOR")
    return out.error(name, "INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR or RGB_COLOR");
  return Header{*values, cosine};
}

void push_row(std::span<const double> row, const Header& header, MeasuredPairs& pairs) {
  pairs.wi.insert(pairs.wi.end(), {std::sin(row[0]), 0, std::cos(row[0])});
  const double theta = std::hypot(row[1], row[2]);
  const double sinc = theta > 0 ? std::sin(theta) / theta : 1;
  const double cosine = std::cos(theta);
  const bool above = cosine > kLeastCosine;
  pairs.wo.insert(pairs.wo.end(), {sinc * row[1], sinc * row[2], above ? cosine : 0});
  for (const double value : row.subspan(kAngles))
    pairs.values.push_back(header.cosine && above ? value / cosine : value);
}

}  // namespace

Result<MeasuredPairs> parse_alta(std::string_view text, const std::string& name) {
  const auto plain = utf8_text(text, name);
  if (!plain) return plain.error();
  const auto header = read_header(*plain, name);
  if (!header) return header.error();
  MeasuredPairs pairs;
  pairs.channels = header->values;
  TextRows rows(*plain, name);
  std::vector<double> numbers(kAngles + static_cast<std::size_t>(header->values));
  const std::string what =
      "theta_i, theta_o cos(dphi), theta_o sin(dphi) in radians and as many values as #DIM 3 " +
      std::to_string(header->values) + " says";
  for (;;) {
    const auto row = rows.row(numbers, what);
    if (!row) return row.error();
    if (!*row) break;
    push_row(numbers, *header, pairs);
  }
  if (pairs.size() == 0) return rows.error("the end of the file", "rows of " + what);
  return pairs;
}

Result<MeasuredPairs> read_alta(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse_alta(*text, file.string());
}

}  // namespace gonio
