#include <algorithm>
#include <cmath>
#include <sstream>

#include "measured/pairs.h"
#include "measured/text_file.h"

namespace gonio {
namespace {

constexpr int kMostValues = 64;

struct Header {
  int values = 0;  // of a row
  bool cosine = false;
};

Error header_error(const std::string& name, const std::string& found, const std::string& expected) {
  return {ErrorCode::data_loss, name + ": found " + found + "; expected " + expected, name, found,
          expected};
}

// What follows `#WORD` on a line of its own; empty if there is none.
std::string entry(std::string_view text, std::string_view word) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    const bool found = line.size() > word.size() && line.substr(0, word.size()) == word &&
                       (line[word.size()] == ' ' || line[word.size()] == '\t');
    if (!found) continue;
    line.remove_prefix(word.size());
    const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return std::string(line.substr(first, last - first + 1));
  }
  return {};
}

Result<Header> read_header(std::string_view text, const std::string& name) {
  Header header;
  const std::string dimensions = entry(text, "#DIM");
  std::istringstream numbers(dimensions.substr(0, 100));
  int from = 0;
  if (!(numbers >> from >> header.values) || from != 3 || header.values < 1 ||
      header.values > kMostValues) {
    return header_error(name, "#DIM " + dimensions.substr(0, 100),
                        "#DIM 3 and the number of values, 1 to " + std::to_string(kMostValues));
  }
  const std::string in = entry(text, "#PARAM_IN");
  if (in != "ISOTROPIC_TL_TV_PROJ_DPHI") {
    return header_error(name, "#PARAM_IN " + in.substr(0, 100),
                        "#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI");
  }
  const std::string vertical = entry(text, "#VS");
  if (!vertical.empty() && vertical != "0")
    return header_error(name, "#VS " + vertical.substr(0, 100), "#VS 0: values without intervals");
  const std::string out = entry(text, "#PARAM_OUT");
  header.cosine = out == "INV_STERADIAN_COSINE_FACTOR";
  if (!header.cosine && !out.empty() && out != "INV_STERADIAN" && out != "RGB_COLOR") {
    return header_error(name, "#PARAM_OUT " + out.substr(0, 100),
                        "INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR or RGB_COLOR");
  }
  return header;
}

Outcome read_row(TextWords& words, const Header& header, MeasuredPairs& pairs) {
  double angles[3];
  for (double& angle : angles) {
    const auto number = words.number("an angle in radians");
    if (!number) return number.error();
    angle = *number;
  }
  pairs.wi.insert(pairs.wi.end(), {std::sin(angles[0]), 0, std::cos(angles[0])});
  const double theta = std::hypot(angles[1], angles[2]);
  const double sinc = theta > 0 ? std::sin(theta) / theta : 1;
  const double cosine = std::cos(theta);
  const bool above = cosine > kLeastCosine;
  pairs.wo.insert(pairs.wo.end(), {sinc * angles[1], sinc * angles[2], above ? cosine : 0});
  for (int i = 0; i < header.values; ++i) {
    const auto value = words.number("a value");
    if (!value) return value.error();
    pairs.values.push_back(header.cosine && above ? *value / cosine : *value);
  }
  return Ok{};
}

}  // namespace

Result<MeasuredPairs> parse_alta(std::string_view text, const std::string& name) {
  const auto header = read_header(text, name);
  if (!header) return header.error();
  MeasuredPairs pairs;
  pairs.channels = header->values;
  TextWords words(text, name);
  while (!words.at_end()) {
    if (auto row = read_row(words, *header, pairs); !row) return row.error();
  }
  if (pairs.size() == 0) return words.error("the end of the file", "rows of measurements");
  return pairs;
}

Result<MeasuredPairs> read_alta(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse_alta(*text, file.string());
}

}  // namespace gonio
