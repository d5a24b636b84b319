#include "measured/merl/review.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "measured/merl/cells.h"
#include "measured/merl/holes.h"

namespace gonio {
namespace {

using Table = MeasuredTable;

constexpr std::array<const char*, Table::kChannels> kChannelNames{"red", "green", "blue"};
constexpr int kRange = 10;               // cells
constexpr std::uint64_t kFewest = 1000;  // cells of a range that says something
constexpr float kFaint = 1e-3F;          // 1/sr: noise of a black material is no outlier

struct Count {
  std::uint64_t all = 0, missing = 0;

  void add(bool is_missing) {
    ++all;
    missing += is_missing ? 1 : 0;
  }
  [[nodiscard]] double share() const {
    return all > 0 ? static_cast<double>(missing) / static_cast<double>(all) : 0;
  }
};

void keep_larger(CellFinding& worst, double value, const Cell& cell, std::size_t channel) {
  if (!(value > worst.value)) return;
  worst = {value, place_of(cell) + ", " + kChannelNames[channel]};
}

// How many times as bright a cell is as the brightest of those two and three cells to both sides,
// where both sides have some.
double peak_along(const CellView& view, const Cell& cell, CellAxis axis, float value) {
  float most = kFaint;
  for (const int side : {-1, 1}) {
    const float a = view.beside(cell, axis, 2 * side);
    // Three steps back from the second cell its mirror image is that cell itself.
    const bool itself = side < 0 && ((axis == CellAxis::theta_h && cell.h == 1) ||
                                     (axis == CellAxis::theta_d && cell.d == 1));
    const float b =
        itself ? std::numeric_limits<float>::quiet_NaN() : view.beside(cell, axis, 3 * side);
    if (std::isnan(a) && std::isnan(b)) return 0;
    most = std::max({most, std::isnan(a) ? 0 : a, std::isnan(b) ? 0 : b});
  }
  return static_cast<double>(value) / static_cast<double>(most);
}

class Review {
 public:
  explicit Review(const Table& table) : table_(table) {}

  TableReview run() {
    for (int h = 0; h < Table::kThetaH; ++h) {
      for (int d = 0; d < Table::kThetaD; ++d) add_row(h, d);
    }
    found_.cells = all_.all;
    found_.missing = {all_.share(), worst_channel()};
    find_worst_range("theta_h", by_h_, 90, true);
    find_worst_range("theta_d", by_d_, 90, false);
    find_worst_range("phi_d", by_p_, 180, false);
    for (std::size_t c = 0; c < zeros_.size(); ++c) {
      if (zeros_[c].share() > found_.zeros.value)
        found_.zeros = {zeros_[c].share(), kChannelNames[c]};
    }
    found_.holes.value = masked_.share();
    return found_;
  }

 private:
  void add_row(int h, int d) {
    static const double least = std::cos(kReviewed * std::numbers::pi / 180);
    const CellCosines cosines(h, d);
    for (int p = 0; p < Table::kPhiD; ++p) {
      const auto [low, high] = cosines.at(p);
      if (!(low > 0)) continue;
      const Cell cell{h, d, p};
      const float* values = table_.data() + cell.index() * Table::kChannels;
      const bool is_missing = std::isnan(values[0]);
      if (low >= least) count(cell, values, is_missing);
      if (!is_missing) look_at_size(cell, values, low * high);
    }
  }

  void count(const Cell& cell, const float* values, bool is_missing) {
    all_.add(is_missing);
    by_h_[static_cast<std::size_t>(cell.h / kRange)].add(is_missing);
    by_d_[static_cast<std::size_t>(cell.d / kRange)].add(is_missing);
    by_p_[static_cast<std::size_t>(cell.p / kRange)].add(is_missing);
    if (is_missing) return;
    for (std::size_t c = 0; c < zeros_.size(); ++c) zeros_[c].add(values[c] == 0);
    const bool masked = is_masked(table_.data(), cell.h, cell.d, cell.p);
    masked_.add(masked);
    if (masked && found_.holes.where.empty()) found_.holes.where = place_of(cell);
  }

  void look_at_size(const Cell& cell, const float* values, double cosines) {
    for (std::size_t c = 0; c < Table::kChannels; ++c) {
      keep_larger(found_.extreme, static_cast<double>(values[c]) * cosines, cell, c);
      const CellView view(table_.data(), c);
      std::array ratios{peak_along(view, cell, CellAxis::theta_h, values[c]),
                        peak_along(view, cell, CellAxis::theta_d, values[c]),
                        peak_along(view, cell, CellAxis::phi_d, values[c])};
      std::ranges::sort(ratios);
      keep_larger(found_.outlier, ratios[1], cell, c);
    }
  }

  // Where some channels lack more than others: the one that lacks most.
  [[nodiscard]] std::string worst_channel() const {
    int worst = 0, best = 0;
    for (int c = 1; c < Table::kChannels; ++c) {
      if (table_.invalid_cells(c) > table_.invalid_cells(worst)) worst = c;
      if (table_.invalid_cells(c) < table_.invalid_cells(best)) best = c;
    }
    const bool differ = table_.invalid_cells(worst) > table_.invalid_cells(best);
    return differ ? kChannelNames[static_cast<std::size_t>(worst)] : "";
  }

  template <std::size_t kRanges>
  void find_worst_range(const std::string& angle, const std::array<Count, kRanges>& ranges,
                        double degrees, bool squared) {
    for (std::size_t i = 0; i < kRanges; ++i) {
      if (ranges[i].all < kFewest || !(ranges[i].share() > found_.missing_region.value)) continue;
      const auto edge = [&](std::size_t k) {
        const double part = static_cast<double>(k) / static_cast<double>(kRanges);
        return static_cast<int>(std::lround(degrees * (squared ? part * part : part)));
      };
      found_.missing_region = {ranges[i].share(), angle + " " + std::to_string(edge(i)) + " to " +
                                                      std::to_string(edge(i + 1)) + " deg"};
    }
  }

  const Table& table_;
  TableReview found_;
  Count all_, masked_;
  std::array<Count, Table::kChannels> zeros_;
  std::array<Count, Table::kThetaH / kRange> by_h_;
  std::array<Count, Table::kThetaD / kRange> by_d_;
  std::array<Count, Table::kPhiD / kRange> by_p_;
};

}  // namespace

TableReview review(const MeasuredTable& table) { return Review(table).run(); }

}  // namespace gonio
