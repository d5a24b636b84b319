#include <algorithm>
#include <array>
#include <deque>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include "client/cli/csv_fields.h"
#include "client/cli/numbers.h"
#include "client/cli/pair_input.h"
#include "gonio/engine/grid.h"

namespace gonio::cli {
namespace {

constexpr std::array<std::string_view, 6> kDirections = {"wi_x", "wi_y", "wi_z",
                                                         "wo_x", "wo_y", "wo_z"};
constexpr std::array<std::string_view, 4> kAngles = {"theta_i", "phi_i", "theta_o", "phi_o"};
const char* headers_of(InputKind what) {
  return what == InputKind::pairs ? "a header with the columns wi_x,wi_y,wi_z,wo_x,wo_y,wo_z or "
                                    "theta_i,phi_i,theta_o,phi_o"
                                  : "a header with the columns wi_x,wi_y,wi_z or theta_i,phi_i";
}
constexpr std::size_t kUnused = 99;  // a column that is not ours

// The first half of the names is that of wi.
std::span<const std::string_view> names_of(std::span<const std::string_view> all, InputKind what) {
  return what == InputKind::pairs ? all : all.first(all.size() / 2);
}

// Which of our numbers each column of the file holds.
struct Layout {
  std::vector<std::size_t> targets;  // by column; kUnused for what is not ours
  std::vector<std::string> names;    // by column
  bool angles = false;
  InputKind what = InputKind::pairs;
};

Error header_error(const ByteSource& source, const std::string& problem, std::string_view found,
                   InputKind what) {
  const std::string name(found.substr(0, 100));
  return {ErrorCode::invalid_argument,
          source.name() + ":1: " + problem + ", found '" + name + "'; allowed: " + headers_of(what),
          argument_of(what), name, headers_of(what)};
}

bool assign(std::span<const std::string_view> wanted, Layout& layout) {
  for (const std::string& name : layout.names) {
    const auto found = std::find(wanted.begin(), wanted.end(), name);
    layout.targets.push_back(
        found == wanted.end() ? kUnused : static_cast<std::size_t>(found - wanted.begin()));
  }
  return std::all_of(wanted.begin(), wanted.end(), [&](std::string_view name) {
    return std::count(layout.names.begin(), layout.names.end(), name) == 1;
  });
}

Result<Layout> read_header(ByteSource& source, InputKind what) {
  auto line = source.line();
  if (!line) return line.error();
  if (!*line) {
    return Error{ErrorCode::invalid_argument,
                 source.name() + " is empty; allowed: " + headers_of(what), argument_of(what),
                 "empty", headers_of(what)};
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string_view rest = **line;
  if (rest.substr(0, kByteOrderMark.size()) == kByteOrderMark) rest.remove_prefix(3);
  const std::string text(rest);
  rest = text;
  Layout layout;
  layout.what = what;
  for (bool more = true; more;) layout.names.emplace_back(next_field(rest, more));
  if (assign(names_of(kDirections, what), layout)) return layout;
  layout.targets.clear();
  layout.angles = true;
  if (assign(names_of(kAngles, what), layout)) return layout;
  return header_error(source, "the header lacks a column or has one twice", text, what);
}

template <class T>
class CsvInput final : public PairInput<T> {
 public:
  CsvInput(ByteSource source, Layout layout, bool degrees, bool keep_angles)
      : source_(std::move(source)),
        layout_(std::move(layout)),
        unit_(degrees ? std::numbers::pi / 180 : 1),
        keep_angles_(keep_angles) {}

  Result<std::size_t> read(std::span<T> wi, std::span<T> wo) override {
    const std::size_t most = wi.size() / 3;
    std::size_t pairs = 0;
    while (pairs < most) {
      auto line = source_.line();
      if (!line) return line.error();
      if (!*line) break;
      ++line_number_;
      if (trimmed(**line).empty()) continue;
      const auto to = wi.subspan(3 * pairs, 3), other = has_wo() ? wo.subspan(3 * pairs, 3) : wo;
      auto read =
          layout_.angles ? read_angles(**line, to, other) : read_directions(**line, to, other);
      if (!read) return read.error();
      ++pairs;
    }
    return pairs;
  }

  [[nodiscard]] std::optional<double> progress() const override {
    if (!source_.size() || *source_.size() == 0) return std::nullopt;
    return static_cast<double>(source_.bytes_read()) / static_cast<double>(*source_.size());
  }

  [[nodiscard]] std::vector<std::string> columns() const override {
    if (!layout_.angles) return PairInput<T>::columns();
    return {kAngles.begin(), kAngles.end()};
  }

  std::optional<std::array<double, 4>> take_angles() override {
    if (angles_.empty()) return std::nullopt;
    const auto angles = angles_.front();
    angles_.pop_front();
    return angles;
  }

 private:
  template <class Number>
  Outcome read_fields(std::string_view rest, Number* numbers) {
    std::size_t column = 0;
    for (bool more = true; more; ++column) {
      const std::string_view field = next_field(rest, more);
      if (column >= layout_.targets.size()) return wrong_length(column + 1);
      if (layout_.targets[column] == kUnused) continue;
      const std::optional<Number> number = parse_number<Number>(field);
      if (!number) return not_a_number(column, field);
      numbers[layout_.targets[column]] = *number;
    }
    if (column < layout_.targets.size()) return wrong_length(column);
    return Ok{};
  }

  [[nodiscard]] bool has_wo() const { return layout_.what == InputKind::pairs; }

  Outcome read_directions(std::string_view line, std::span<T> wi, std::span<T> wo) {
    std::array<T, 6> numbers{};
    if (auto read = read_fields(line, numbers.data()); !read) return read;
    std::copy_n(numbers.begin(), 3, wi.begin());
    if (has_wo()) std::copy_n(numbers.begin() + 3, 3, wo.begin());
    return Ok{};
  }

  Outcome read_angles(std::string_view line, std::span<T> wi, std::span<T> wo) {
    std::array<double, 4> angles{};
    if (auto read = read_fields(line, angles.data()); !read) return read;
    if (keep_angles_) angles_.push_back(angles);
    direction_at(angles[0] * unit_, angles[1] * unit_, wi.data());
    if (has_wo()) direction_at(angles[2] * unit_, angles[3] * unit_, wo.data());
    return Ok{};
  }

  Error not_a_number(std::size_t column, std::string_view field) const {
    const std::string value(field.substr(0, 100));
    return {ErrorCode::invalid_argument,
            where() + ", column " + std::to_string(column + 1) + " (" + layout_.names[column] +
                "): '" + value + "' is not a number",
            layout_.names[column], value, "a number"};
  }

  Error wrong_length(std::size_t columns) const {
    const std::string most = std::to_string(layout_.targets.size());
    const bool more = columns > layout_.targets.size();
    return {ErrorCode::invalid_argument,
            where() + ": " + (more ? "more than the " : "fewer than the ") + most +
                " columns of the header" + (more ? "" : " (" + std::to_string(columns) + ")"),
            argument_of(layout_.what), std::to_string(columns), most};
  }

  [[nodiscard]] std::string where() const {
    return source_.name() + ":" + std::to_string(line_number_);
  }

  ByteSource source_;
  Layout layout_;
  double unit_;
  bool keep_angles_;
  std::uint64_t line_number_ = 1;             // the header's
  std::deque<std::array<double, 4>> angles_;  // read, and not yet taken
};

}  // namespace

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_csv(InputKind what, ByteSource source, bool degrees,
                                               bool keep_angles) {
  auto layout = read_header(source, what);
  if (!layout) return layout.error();
  std::unique_ptr<PairInput<T>> input = std::make_unique<CsvInput<T>>(
      std::move(source), std::move(layout).value(), degrees, keep_angles);
  return input;
}

template Result<std::unique_ptr<PairInput<float>>> open_csv(InputKind, ByteSource, bool, bool);
template Result<std::unique_ptr<PairInput<double>>> open_csv(InputKind, ByteSource, bool, bool);

}  // namespace gonio::cli
