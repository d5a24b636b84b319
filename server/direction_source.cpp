#include "server/direction_source.h"

#include <string>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using Kind = wire::Request::Kind;

std::vector<double> axis(const google::protobuf::RepeatedField<double>& values) {
  return {values.begin(), values.end()};
}

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

Result<Grid> make_grid(const v1::Grid& grid) {
  const bool spherical =
      grid.theta_i_size() + grid.phi_i_size() + grid.theta_o_size() + grid.phi_o_size() > 0;
  const bool half_angle = grid.theta_h_size() + grid.theta_d_size() + grid.phi_d_size() > 0;
  constexpr const char* kAllowed =
      "either theta_i, phi_i, theta_o and phi_o, or theta_h, theta_d and phi_d";
  if (spherical && half_angle) return bad_value("grid", "given with axes of both kinds", kAllowed);
  if (!spherical && !half_angle) return bad_value("grid", "without axes", kAllowed);
  if (half_angle)
    return Grid::half_angle(axis(grid.theta_h()), axis(grid.theta_d()), axis(grid.phi_d()));
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

}  // namespace gonio
