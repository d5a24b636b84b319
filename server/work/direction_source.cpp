#include "server/work/direction_source.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace gonio::server {
namespace {

using Kind = wire::Request::Kind;
using Axis = google::protobuf::RepeatedField<double>;

// The axes are prepared by the thread that reads the request, which must not be held up for long.
constexpr std::size_t kMaxAngles = std::size_t{1} << 20;

std::vector<double> axis(const Axis& values) { return {values.begin(), values.end()}; }

Outcome check_lengths(const wire::Request& request, const std::string& field) {
  const std::size_t wi = request.wi.count, wo = request.wo.count;
  constexpr const char* kThrees = "a multiple of 3: x, y, z of each direction";
  if (wi % 3 != 0)
    return bad_value(field + ".wi", "an array of " + std::to_string(wi) + " numbers", kThrees);
  if (wo % 3 != 0)
    return bad_value(field + ".wo", "an array of " + std::to_string(wo) + " numbers", kThrees);
  if (wi == wo) return Ok{};
  return bad_value(field + ".wo", "an array of " + std::to_string(wo) + " numbers",
                   std::to_string(wi) + ", as many as " + field + ".wi has");
}

std::size_t angles_in(std::initializer_list<const Axis*> axes) {
  std::size_t angles = 0;
  for (const Axis* axis : axes) angles += static_cast<std::size_t>(axis->size());
  return angles;
}

Result<Grid> make_grid(const v1::Grid& grid) {
  const std::size_t spherical =
      angles_in({&grid.theta_i(), &grid.phi_i(), &grid.theta_o(), &grid.phi_o()});
  const std::size_t half_angle = angles_in({&grid.theta_h(), &grid.theta_d(), &grid.phi_d()});
  constexpr const char* kAllowed =
      "either theta_i, phi_i, theta_o and phi_o, or theta_h, theta_d and phi_d";
  if (spherical > 0 && half_angle > 0) {
    return bad_value("grid", "given with axes of both kinds", kAllowed);
  }
  if (spherical + half_angle == 0) return bad_value("grid", "without axes", kAllowed);
  if (spherical + half_angle > kMaxAngles) {
    return bad_value("grid", std::to_string(spherical + half_angle) + " angles",
                     "at most " + std::to_string(kMaxAngles) + " angles, all axes together");
  }
  if (half_angle > 0) {
    return Grid::half_angle(axis(grid.theta_h()), axis(grid.theta_d()), axis(grid.phi_d()));
  }
  return Grid::spherical(axis(grid.theta_i()), axis(grid.phi_i()), axis(grid.theta_o()),
                         axis(grid.phi_o()));
}

// The core speaks of "theta_i"; in a request that is "grid.theta_i".
Error in_grid(Error error) {
  if (!error.field.empty() && error.field.rfind("grid", 0) != 0) {
    error.field = "grid." + error.field;
    error.message = "grid." + error.message;
  }
  return error;
}

}  // namespace

Outcome DirectionSource::set_pairs(const wire::Request& request) {
  const auto lengths = check_lengths(request, request.kind == Kind::pairs ? "pairs" : "pairs_f64");
  if (!lengths) return lengths.error();
  bytes_ = request.bytes;
  wi_offset_ = request.wi.offset;
  wo_offset_ = request.wo.offset;
  size_ = request.wi.count / 3;
  return Ok{};
}

Outcome DirectionSource::set_grid(const v1::Grid& grid) {
  auto expanded = make_grid(grid);
  if (!expanded) return in_grid(expanded.error());
  const std::uint64_t all = expanded->size();
  if (grid.first() >= all) {
    return bad_value("grid.first", std::to_string(grid.first()),
                     "below " + std::to_string(all) + ", the number of pairs in the grid");
  }
  const std::uint64_t left = all - grid.first();
  if (grid.count() > left) {
    return bad_value(
        "grid.count", std::to_string(grid.count()),
        "at most " + std::to_string(left) + ", the pairs of the grid from grid.first on");
  }
  size_ = grid.count() == 0 ? left : grid.count();
  grid_first_ = grid.first();
  grid_ = std::move(*expanded);
  return Ok{};
}

Result<DirectionSource> DirectionSource::create(const wire::Request& request, Precision precision) {
  DirectionSource source;
  Outcome outcome = Ok{};
  switch (request.kind) {
    case Kind::none:
      return bad_value("directions", "not given", "pairs, pairs_f64 or grid");
    case Kind::pairs_f64:
      if (precision == Precision::fast) {
        return bad_value("precision", "PRECISION_FAST",
                         "PRECISION_REFERENCE for pairs_f64, or pairs in float32");
      }
      source.is_f64_ = true;
      [[fallthrough]];
    case Kind::pairs:
      outcome = source.set_pairs(request);
      break;
    case Kind::grid:
      source.is_f64_ = precision == Precision::reference;
      outcome = source.set_grid(request.head.grid());
      break;
  }
  if (!outcome) return outcome.error();
  return source;
}

}  // namespace gonio::server
