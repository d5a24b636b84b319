// A measured table in fewer cells, with and without interpolation: bytes against error.
#include <array>
#include <cmath>
#include <limits>

#include "chart/chart.h"
#include "chart/common.h"
#include "fit/report/metrics.h"

namespace gonio::chart {
namespace {

using Full = MeasuredTable;
constexpr std::size_t kChannels = Full::kChannels;

// Cells of theta_h, theta_d and phi_d; each divides the table's own number.
struct Resolution {
  int h, d, p;
};
constexpr std::array kResolutions{
    Resolution{90, 90, 180}, Resolution{90, 90, 36}, Resolution{90, 90, 6}, Resolution{90, 90, 1},
    Resolution{90, 30, 6},   Resolution{90, 15, 6},  Resolution{90, 15, 1}, Resolution{45, 45, 90},
    Resolution{30, 30, 60},  Resolution{18, 18, 36}, Resolution{30, 10, 6}, Resolution{15, 15, 30}};

std::size_t cells_of(const Resolution& r) {
  return static_cast<std::size_t>(r.h) * static_cast<std::size_t>(r.d) *
         static_cast<std::size_t>(r.p);
}

std::size_t index_of(const Resolution& r, int h, int d, int p) {
  return (static_cast<std::size_t>(h) * static_cast<std::size_t>(r.d) +
          static_cast<std::size_t>(d)) *
             static_cast<std::size_t>(r.p) +
         static_cast<std::size_t>(p);
}

constexpr Resolution kFull{Full::kThetaH, Full::kThetaD, Full::kPhiD};

// Means of the cells that hold a measurement; NaN where there is none.
std::vector<float> coarse(const Full& table, const Resolution& r) {
  std::vector<double> sums(cells_of(r) * kChannels);
  std::vector<int> counts(cells_of(r));
  for (int h = 0; h < kFull.h; ++h) {
    for (int d = 0; d < kFull.d; ++d) {
      for (int p = 0; p < kFull.p; ++p) {
        const float* value = table.data() + index_of(kFull, h, d, p) * kChannels;
        if (std::isnan(value[0])) continue;
        const std::size_t to = index_of(r, h * r.h / kFull.h, d * r.d / kFull.d, p * r.p / kFull.p);
        ++counts[to];
        for (std::size_t c = 0; c < kChannels; ++c) sums[to * kChannels + c] += value[c];
      }
    }
  }
  std::vector<float> means(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    means[i] = static_cast<float>(sums[i] / counts[i / kChannels]);  // 0/0 is NaN
  return means;
}

// A position on one axis: between two cells, or in one.
struct Between {
  int lower, upper;
  float weight;  // of the upper cell
};
Between between(int fine, int fine_cells, int cells, bool linear, bool periodic) {
  const double at = (fine + 0.5) * cells / fine_cells;
  if (!linear || cells == 1) return {static_cast<int>(at), static_cast<int>(at), 0};
  const double from = periodic ? at - 0.5 : std::clamp(at - 0.5, 0.0, cells - 1.0);
  const int lower = static_cast<int>(std::floor(from));
  const auto weight = static_cast<float>(from - lower);
  if (periodic) return {(lower + cells) % cells, (lower + 1) % cells, weight};
  return {lower, std::min(lower + 1, cells - 1), weight};
}

// One of the full table's cells from a coarse one, as measured/merl/eval.h
// interpolates.
void fill(const std::vector<float>& values, const Resolution& r, const Between (&axis)[3],
          float* to) {
  float total = 0, sums[kChannels] = {};
  for (int corner = 0; corner < 8; ++corner) {
    int cell[3];
    float weight = 1;
    for (int k = 0; k < 3; ++k) {
      const bool far = (corner >> k & 1) != 0;
      cell[k] = far ? axis[k].upper : axis[k].lower;
      weight *= far ? axis[k].weight : 1 - axis[k].weight;
    }
    const float* value = &values[index_of(r, cell[0], cell[1], cell[2]) * kChannels];
    if (weight == 0 || std::isnan(value[0])) continue;
    total += weight;
    for (std::size_t c = 0; c < kChannels; ++c) sums[c] += weight * value[c];
  }
  for (std::size_t c = 0; c < kChannels; ++c)
    to[c] = total > 0 ? sums[c] / total : std::numeric_limits<float>::quiet_NaN();
}

// The values of the coarse table at the centres of all cells of the full one.
std::shared_ptr<const Full> expanded(const std::vector<float>& values, const Resolution& r,
                                     bool linear) {
  std::vector<float> full(Full::kCells * kChannels);
  for (int h = 0; h < kFull.h; ++h) {
    for (int d = 0; d < kFull.d; ++d) {
      for (int p = 0; p < kFull.p; ++p) {
        const Between axis[3] = {between(h, kFull.h, r.h, linear, false),
                                 between(d, kFull.d, r.d, linear, false),
                                 between(p, kFull.p, r.p, linear, true)};
        fill(values, r, axis, &full[index_of(kFull, h, d, p) * kChannels]);
      }
    }
  }
  return *Full::from_values(full);
}

}  // namespace

Result<Table> chart_resolution(const Measured& measured, const Options& options) {
  Table table{"resolution",
              "A table of " + measured.name + " in fewer cells: bytes against error at its cells",
              {{"cells", "", "of theta_h, theta_d and phi_d"},
               {"interpolation", "", "nearest: the cell's mean; linear: between the eight around"},
               {"bytes", "B", "in float32"},
               {"l1_all", "1", "relative, weighed by the cosine of incidence; all angles"},
               {"l1_below_80", "1", "both angles up to 80 degrees"},
               {"cbrt_all", "1", "root mean square of cube roots; all angles"}},
              {}};
  for (const Resolution& r : kResolutions) {
    const std::vector<float> values = coarse(*measured.table, r);
    for (const bool linear : {false, true}) {
      if (is_over(options)) return was_cancelled();
      const auto full = expanded(values, r, linear);
      const auto errors =
          fit::compare(Material::from_table(full, Interpolation::nearest), measured.data, 0).errors;
      table.rows.push_back(
          {std::to_string(r.h) + " x " + std::to_string(r.d) + " x " + std::to_string(r.p),
           std::string(linear ? "linear" : "nearest"),
           static_cast<double>(cells_of(r) * kChannels * sizeof(float)), errors.all.l1,
           errors.below_80.l1, errors.all.cbrt});
    }
    show(options, static_cast<double>(table.rows.size()) / (2.0 * kResolutions.size()));
  }
  add_front(table, "bytes", "l1_all", "");
  return table;
}

}  // namespace gonio::chart
