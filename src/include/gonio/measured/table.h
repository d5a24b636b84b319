// A measured isotropic BRDF over Rusinkiewicz' half and difference angles, as the MERL database
// tabulates it.
//
// 90 cells of theta_h (quadratically spaced) x 90 of theta_d x 180 of phi_d (half a turn; the other
// half follows by reciprocity), 3 channels (R, G, B) in 1/sr, held as float32. Cells without a
// valid measurement hold NaN in every channel. Thread safety: immutable. Source: Matusik, Pfister,
// Brand & McMillan 2003, "A Data-Driven Reflectance Model".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "gonio/base/result.h"

namespace gonio {

// The cells that hold no measurement where there could be one: a bit a cell, in the table's order.
struct HoleMap {
  std::size_t count = 0;
  // Both empty if there are none. `around`: of each cell, whether it or one after it, along any of
  // the axes, is one: what a lookup between eight cells meets from the first.
  std::vector<std::uint64_t> cells, around;
};

class MeasuredTable {
 public:
  static constexpr int kThetaH = 90, kThetaD = 90, kPhiD = 180, kChannels = 3;
  static constexpr std::size_t kCells = std::size_t{kThetaH} * kThetaD * kPhiD;
  // Of a MERL `.binary`: every one has this size.
  static constexpr std::size_t kFileBytes = 12 + 8 * kChannels * kCells;

  // Reads a MERL `.binary`: three int32 dimensions (90 90 180), then planes of float64 for R, G and
  // B that are scaled here by 1/1500, 1.15/1500 and 1.66/1500. A cell that is negative in any
  // channel is taken as not measured. Errors: not_found, invalid_argument (a folder, a pipe),
  // data_loss (other dimensions, truncated, too long, a value that is not finite in float32), each
  // naming file, found and expected.
  static Result<std::shared_ptr<const MeasuredTable>> read_merl(const std::filesystem::path& file);
  // The same from such a file's content; `name` is what errors call it.
  static Result<std::shared_ptr<const MeasuredTable>> parse_merl(std::string content,
                                                                 const std::string& name);

  // From values in 1/sr, cell-major ([theta_h][theta_d][phi_d][channel]); NaN or negative marks an
  // invalid cell.
  static Result<std::shared_ptr<const MeasuredTable>> from_values(std::span<const float> values);

  // [theta_h][theta_d][phi_d][channel].
  [[nodiscard]] const float* data() const { return values_.data(); }
  [[nodiscard]] std::size_t invalid_cells() const { return invalid_cells_; }
  // Of these, those that lack the channel.
  [[nodiscard]] std::size_t invalid_cells(int channel) const {
    return invalid_in_[static_cast<std::size_t>(channel)];
  }
  // Cells above the horizon that are invalid, or far darker than what is on both sides of them
  // (measured/merl/holes.h). Searched for when first asked for (some 50 ms).
  [[nodiscard]] const HoleMap& holes() const;

 private:
  static Result<std::shared_ptr<const MeasuredTable>> read_merl(std::istream& in, std::size_t bytes,
                                                                const std::string& name);

  std::vector<float> values_;
  std::size_t invalid_cells_ = 0;
  std::array<std::size_t, kChannels> invalid_in_{};
  mutable std::once_flag search_;
  mutable HoleMap holes_;
};

}  // namespace gonio
