#include <algorithm>
#include <array>
#include <deque>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include "client/cli/input/csv/csv_table.h"
#include "client/cli/input/pair_input.h"
#include "client/cli/input/place_columns.h"
#include "gonio/engine/grid.h"

namespace gonio::cli {
namespace {

CsvWanted wanted(InputKind what) {
  const bool pairs = what == InputKind::pairs;
  const NameSet directions = kDirectionColumns, angles = kAngleColumns;
  const auto part = [&](NameSet all) { return pairs ? all : all.first(all.size() / 2); };
  return {{part(directions), part(angles)},
          argument_of(what),
          pairs ? "a header with the columns wi_x,wi_y,wi_z,wo_x,wo_y,wo_z or "
                  "theta_i,phi_i,theta_o,phi_o"
                : "a header with the columns wi_x,wi_y,wi_z or theta_i,phi_i"};
}

template <class T>
class CsvInput final : public PairInput<T> {
 public:
  CsvInput(InputKind what, CsvTable table, bool degrees, bool keep_angles)
      : table_(std::move(table)),
        targets_(table_.header().names.size(), kNoColumn),
        is_angles_(table_.header().set == kAngleSet),
        has_wo_(what == InputKind::pairs),
        unit_(degrees ? std::numbers::pi / 180 : 1),
        keep_angles_(keep_angles) {
    const auto& places = table_.header().places;
    for (std::size_t i = 0; i < places.size(); ++i) targets_[places[i]] = i;
  }

  Result<std::size_t> read(std::span<T> wi, std::span<T> wo) override {
    const std::size_t most = wi.size() / 3;
    std::size_t pairs = 0;
    for (; pairs < most; ++pairs) {
      std::string_view row;
      auto more = table_.next_row(row);
      if (!more) return more.error();
      if (!*more) break;
      const auto to = wi.subspan(3 * pairs, 3), other = has_wo_ ? wo.subspan(3 * pairs, 3) : wo;
      auto read = is_angles_ ? read_angles(row, to, other) : read_directions(row, to, other);
      if (!read) return read.error();
    }
    return pairs;
  }

  [[nodiscard]] std::optional<double> progress() const override {
    const ByteSource& source = table_.source();
    if (!source.size() || *source.size() == 0) return std::nullopt;
    return static_cast<double>(source.bytes_read()) / static_cast<double>(*source.size());
  }

  [[nodiscard]] std::vector<std::string> columns() const override {
    if (!is_angles_) return PairInput<T>::columns();
    return {kAngleColumns.begin(), kAngleColumns.end()};
  }

  std::optional<std::array<double, 4>> take_angles() override {
    if (angles_.empty()) return std::nullopt;
    const auto angles = angles_.front();
    angles_.pop_front();
    return angles;
  }

 private:
  Outcome read_directions(std::string_view row, std::span<T> wi, std::span<T> wo) {
    std::array<T, 6> numbers{};
    if (auto read = table_.read(row, targets_, numbers.data()); !read) return read;
    std::copy_n(numbers.begin(), 3, wi.begin());
    if (has_wo_) std::copy_n(numbers.begin() + 3, 3, wo.begin());
    return Ok{};
  }

  Outcome read_angles(std::string_view row, std::span<T> wi, std::span<T> wo) {
    std::array<double, 4> angles{};
    if (auto read = table_.read(row, targets_, angles.data()); !read) return read;
    if (keep_angles_) angles_.push_back(angles);
    direction_at(angles[0] * unit_, angles[1] * unit_, wi.data());
    if (has_wo_) direction_at(angles[2] * unit_, angles[3] * unit_, wo.data());
    return Ok{};
  }

  CsvTable table_;
  std::vector<std::size_t> targets_;  // by column: which of our numbers it holds
  bool is_angles_, has_wo_;
  double unit_;
  bool keep_angles_;
  std::deque<std::array<double, 4>> angles_;  // read, and not yet taken
};

}  // namespace

template <class T>
Result<std::unique_ptr<PairInput<T>>> open_csv(InputKind what, ByteSource source, bool degrees,
                                               bool keep_angles) {
  auto table = CsvTable::open(std::move(source), wanted(what));
  if (!table) return table.error();
  std::unique_ptr<PairInput<T>> input =
      std::make_unique<CsvInput<T>>(what, std::move(table).value(), degrees, keep_angles);
  return input;
}

template Result<std::unique_ptr<PairInput<float>>> open_csv(InputKind, ByteSource, bool, bool);
template Result<std::unique_ptr<PairInput<double>>> open_csv(InputKind, ByteSource, bool, bool);

}  // namespace gonio::cli
