// Reads MERL `.binary` files. The file's planes are read block by block, so that the table itself
// is all the memory that a file costs.
#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "gonio/measured/table.h"
#include "measured/file_error.h"

namespace gonio {
namespace {

static_assert(std::endian::native == std::endian::little, "MERL files are little-endian");

using Table = MeasuredTable;
using Dimensions = std::array<std::int32_t, 3>;

constexpr std::array<double, Table::kChannels> kScale{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
constexpr std::array<const char*, Table::kChannels> kChannelNames{"R", "G", "B"};
constexpr Dimensions kDimensions{Table::kThetaH, Table::kThetaD, Table::kPhiD};
static_assert(Table::kFileBytes ==
              sizeof(Dimensions) + sizeof(double) * Table::kChannels * Table::kCells);
constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();

std::string text_of(const Dimensions& dimensions) {
  return std::to_string(dimensions[0]) + " " + std::to_string(dimensions[1]) + " " +
         std::to_string(dimensions[2]);
}

std::string cell_name(std::size_t cell) {
  const std::size_t phi_d = cell % Table::kPhiD;
  const std::size_t theta_d = cell / Table::kPhiD % Table::kThetaD;
  const std::size_t theta_h = cell / Table::kPhiD / Table::kThetaD;
  return "cell [theta_h " + std::to_string(theta_h) + "][theta_d " + std::to_string(theta_d) +
         "][phi_d " + std::to_string(phi_d) + "]";
}

Error wrong_length(const std::string& file, std::uintmax_t bytes) {
  constexpr std::uintmax_t kRight = Table::kFileBytes;
  std::string found = std::to_string(bytes) + " bytes (";
  found += bytes < kRight ? "truncated: " + std::to_string(kRight - bytes) + " missing)"
                          : "too long by " + std::to_string(bytes - kRight) + ")";
  return file_error(ErrorCode::data_loss, file, found, std::to_string(kRight) + " bytes");
}

// What can be said before opening: opening a pipe or a device might block for ever.
Outcome check_kind(const std::string& file) {
  const char* expected = "a MERL .binary file";
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (status.type() == std::filesystem::file_type::not_found) {
    return file_error(ErrorCode::not_found, file, "no such file", expected);
  }
  if (problem) return file_error(ErrorCode::not_found, file, problem.message(), expected);
  if (std::filesystem::is_directory(status)) {
    return file_error(ErrorCode::invalid_argument, file, "a folder", expected);
  }
  if (!std::filesystem::is_regular_file(status)) {
    return file_error(ErrorCode::invalid_argument, file, "a pipe, socket or device", expected);
  }
  return Ok{};
}

// The header comes before the length: a file of another kind is better told by its dimensions than
// by its size.
Outcome check_header(std::istream& in, std::uintmax_t bytes, const std::string& file) {
  Dimensions found{};
  if (!in.read(reinterpret_cast<char*>(found.data()), sizeof found))
    return wrong_length(file, bytes);
  if (found != kDimensions) {
    return file_error(ErrorCode::data_loss, file, "the dimensions " + text_of(found),
                      "the dimensions " + text_of(kDimensions));
  }
  if (bytes != Table::kFileBytes) return wrong_length(file, bytes);
  return Ok{};
}

// Reads one plane into its channel of the cell-major `values`; negative cells become kInvalid.
Outcome read_plane(std::istream& in, const std::string& file, int channel,
                   std::span<float> values) {
  std::array<double, 8192> block;
  const auto c = static_cast<std::size_t>(channel);
  for (std::size_t first = 0; first < Table::kCells; first += block.size()) {
    const std::size_t count = std::min(block.size(), Table::kCells - first);
    // The length was right a moment ago, so that a short read means that the file changed under us.
    if (!in.read(reinterpret_cast<char*>(block.data()),
                 static_cast<std::streamsize>(count * sizeof(double)))) {
      return file_error(ErrorCode::data_loss, file, "the end of the file inside the data",
                        "all cells");
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double scaled = block[i] * kScale[c];
      if (!std::isfinite(block[i]) ||
          scaled > static_cast<double>(std::numeric_limits<float>::max())) {
        return file_error(
            ErrorCode::data_loss, file,
            std::to_string(block[i]) + " in " + cell_name(first + i) + " of " + kChannelNames[c],
            "finite float32 values");
      }
      values[(first + i) * Table::kChannels + c] =
          block[i] < 0 ? kInvalid : static_cast<float>(scaled);
    }
  }
  return Ok{};
}

// A cell that lacks one channel lacks all; returns how many do, and adds those of each channel.
// Adding 0 makes -0 a plain 0.
std::size_t mark_invalid(std::span<float> values,
                         std::array<std::size_t, Table::kChannels>& in_channel) {
  std::size_t invalid = 0;
  const auto is_missing = [](float v) { return std::isnan(v) || v < 0; };
  for (std::size_t i = 0; i < values.size(); i += Table::kChannels) {
    const auto cell = values.subspan(i, Table::kChannels);
    if (std::ranges::any_of(cell, is_missing)) {
      for (std::size_t c = 0; c < cell.size(); ++c) in_channel[c] += is_missing(cell[c]) ? 1 : 0;
      std::ranges::fill(cell, kInvalid);
      ++invalid;
    } else {
      std::ranges::for_each(cell, [](float& v) { v += 0.0F; });
    }
  }
  return invalid;
}

}  // namespace

Result<std::shared_ptr<const MeasuredTable>> MeasuredTable::read_merl(std::istream& in,
                                                                      std::size_t bytes,
                                                                      const std::string& name) {
  if (auto header = check_header(in, bytes, name); !header) return header.error();
  auto table = std::make_shared<MeasuredTable>();
  table->values_.resize(kCells * kChannels);
  for (int channel = 0; channel < kChannels; ++channel) {
    if (auto plane = read_plane(in, name, channel, table->values_); !plane) return plane.error();
  }
  if (in.peek() != std::istream::traits_type::eof()) {
    return file_error(ErrorCode::data_loss, name, "bytes after the last cell",
                      std::to_string(kFileBytes) + " bytes");
  }
  table->invalid_cells_ = mark_invalid(table->values_, table->invalid_in_);
  return std::shared_ptr<const MeasuredTable>(std::move(table));
}

Result<std::shared_ptr<const MeasuredTable>> MeasuredTable::read_merl(
    const std::filesystem::path& file) {
  if (auto kind = check_kind(file.string()); !kind) return kind.error();
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return file_error(ErrorCode::not_found, file.string(), std::strerror(errno), "a readable file");
  }
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
  if (problem) {
    return file_error(ErrorCode::not_found, file.string(), problem.message(), "a readable file");
  }
  return read_merl(in, bytes, file.string());
}

Result<std::shared_ptr<const MeasuredTable>> MeasuredTable::parse_merl(std::string content,
                                                                       const std::string& name) {
  const std::size_t bytes = content.size();
  std::istringstream in(std::move(content));
  return read_merl(in, bytes, name);
}

Result<std::shared_ptr<const MeasuredTable>> MeasuredTable::from_values(
    std::span<const float> values) {
  if (values.size() != kCells * kChannels) {
    return bad_value("values", std::to_string(values.size()) + " numbers",
                     std::to_string(kCells * kChannels));
  }
  const auto infinite = std::ranges::find_if(values, [](float v) { return std::isinf(v); });
  if (infinite != values.end()) {
    const auto index = static_cast<std::size_t>(infinite - values.begin());
    return bad_value(
        "values: " + cell_name(index / kChannels) + " of " + kChannelNames[index % kChannels],
        std::to_string(*infinite), "finite numbers, or NaN for an invalid cell");
  }
  auto table = std::make_shared<MeasuredTable>();
  table->values_.assign(values.begin(), values.end());
  table->invalid_cells_ = mark_invalid(table->values_, table->invalid_in_);
  return std::shared_ptr<const MeasuredTable>(std::move(table));
}

}  // namespace gonio
