// Files of the RGL material database: Dupuy and Jakob, "An Adaptive Parameterization for Efficient
// Material Acquisition and Rendering" (2018), section 5. For each angle of incidence the measured
// directions stand on a grid that the distribution of visible normals of a retro-reflection
// measurement bends towards the lobe; a file holds f cos(theta_o) over that density's Jacobian.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "measured/bilinear_density.h"
#include "measured/pairs.h"
#include "measured/tensor_file.h"
#include "measured/text_file.h"

namespace gonio {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kChannels = 3;

// What a file holds, its dimensions checked against each other. Angles stand on axes that give
// steep directions room: theta = pi/2 u^2, phi = (2 v - 1) pi.
struct Rgl {
  TensorFile::Tensor theta_i, ndf, sigma, vndf, rgb;
  bool jacobian = true;
};

struct Vector {
  double x, y, z;
};

// A table of angles, [phi][theta], of an isotropic surface: the same for every phi.
double along_theta(const TensorFile::Tensor& table, double u) {
  const std::size_t width = table.shape[1];
  const double place = std::clamp(u, 0.0, 1.0) * static_cast<double>(width - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(place), width - 2);
  const double part = place - static_cast<double>(left);
  return (1 - part) * static_cast<double>(table.values[left]) +
         part * static_cast<double>(table.values[left + 1]);
}

Result<Rgl> read(const TensorFile& file) {
  const auto phi = file.floats("phi_i", 1);
  if (!phi) return phi.error();
  if (phi->values.size() != 1)
    return file.error(std::to_string(phi->values.size()) + " azimuths of incidence",
                      "one, of an isotropic material");
  Rgl rgl;
  for (const auto& [name, dimensions, tensor] :
       {std::tuple{"theta_i", 1, &rgl.theta_i}, std::tuple{"ndf", 2, &rgl.ndf},
        std::tuple{"sigma", 2, &rgl.sigma}, std::tuple{"vndf", 4, &rgl.vndf},
        std::tuple{"rgb", 5, &rgl.rgb}}) {
    auto read = file.floats(name, static_cast<std::size_t>(dimensions));
    if (!read) return read.error();
    *tensor = std::move(*read);
  }
  const auto jacobian = file.byte("jacobian");
  if (!jacobian) return jacobian.error();
  rgl.jacobian = *jacobian != 0;
  return rgl;
}

Outcome check(const Rgl& rgl, const TensorFile& file) {
  const std::uint64_t angles = rgl.theta_i.shape[0];
  for (const auto* tensor : {&rgl.vndf, &rgl.rgb}) {
    if (tensor->shape[0] != 1 || tensor->shape[1] != angles)
      return file.error("tables of " + std::to_string(tensor->shape[1]) + " angles",
                        std::to_string(angles) + ", as theta_i has");
  }
  for (const auto* tensor : {&rgl.ndf, &rgl.sigma, &rgl.vndf, &rgl.rgb}) {
    const auto n = tensor->shape.size();
    if (tensor->shape[n - 1] < 2 || (n > 2 && tensor->shape[n - 2] < 2))
      return file.error("a table of less than 2 nodes a side", "at least 2");
  }
  if (rgl.rgb.shape[2] != kChannels)
    return file.error(std::to_string(rgl.rgb.shape[2]) + " channels in 'rgb'", "3");
  const auto is_angle = [](float theta) { return theta >= 0 && theta < 1.5708F; };
  const auto& theta = rgl.theta_i.values;
  if (!std::all_of(theta.begin(), theta.end(), is_angle) ||
      std::adjacent_find(theta.begin(), theta.end(), std::greater_equal<>()) != theta.end())
    return file.error("angles 'theta_i' that do not rise from 0 to pi/2", "such angles");
  const auto is_density = [](float d) { return std::isfinite(d) && d >= 0; };
  for (const auto* tensor : {&rgl.ndf, &rgl.sigma, &rgl.vndf}) {
    if (!std::all_of(tensor->values.begin(), tensor->values.end(), is_density))
      return file.error("a density that is negative or not finite", "densities");
  }
  return Ok{};
}

// The part of all incidence, in sr, that each angle stands for: half way to its neighbours.
double zone(const std::vector<float>& theta, std::size_t i) {
  const auto between = [&](std::size_t a) {
    return (static_cast<double>(theta[a]) + static_cast<double>(theta[a + 1])) / 2;
  };
  const double from = i == 0 ? 0 : between(i - 1);
  const double to = i + 1 == theta.size() ? kPi / 2 : between(i);
  return 2 * kPi * (std::cos(from) - std::cos(to));
}

// One angle of incidence: its light, what it stands for, and its grid of normals.
class Incidence {
 public:
  Incidence(const Rgl& rgl, std::size_t angle)
      : rgl_(rgl),
        theta_(static_cast<double>(rgl.theta_i.values[angle])),
        wi_{std::sin(theta_), 0, std::max(std::cos(theta_), 0.0)},
        sigma_(along_theta(rgl.sigma, std::sqrt(theta_ * 2 / kPi))),
        zone_(zone(rgl.theta_i.values, angle)),
        normals_(table_of(rgl.vndf, angle), rgl.vndf.shape[3], rgl.vndf.shape[2]),
        colours_(table_of(rgl.rgb, angle)) {}

  void add_nodes(MeasuredPairs& pairs) const {
    const std::uint64_t width = rgl_.rgb.shape[4], height = rgl_.rgb.shape[3];
    for (std::uint64_t y = 0; y < height; ++y) {
      for (std::uint64_t x = 0; x < width; ++x)
        add_node(place_of(x, width), place_of(y, height), &colours_[y * width + x], width * height,
                 pairs);
    }
  }

 private:
  // Of a node: where it stands from 0 to 1, and the part of that length that it stands for.
  struct Place {
    double at, part;
  };

  static Place place_of(std::uint64_t i, std::uint64_t count) {
    const auto last = static_cast<double>(count - 1);
    return {static_cast<double>(i) / last, (i == 0 || i + 1 == count ? 0.5 : 1.0) / last};
  }

  static std::span<const float> table_of(const TensorFile::Tensor& tensor, std::size_t angle) {
    const std::size_t size = tensor.values.size() / tensor.shape[1];
    return std::span(tensor.values).subspan(angle * size, size);
  }

  // `colour` points to the red value, the others follow at distances of `plane`.
  void add_node(Place x, Place y, const float* colour, std::uint64_t plane,
                MeasuredPairs& pairs) const {
    const auto normal = normals_.at(x.at, y.at);
    const double theta_m = normal.u * normal.u * kPi / 2, phi_m = (2 * normal.v - 1) * kPi;
    const double sine = std::sin(theta_m);
    const Vector wm{sine * std::cos(phi_m), sine * std::sin(phi_m), std::cos(theta_m)};
    const double cosine = wi_.x * wm.x + wi_.z * wm.z;
    const Vector wo{2 * cosine * wm.x - wi_.x, 2 * cosine * wm.y, 2 * cosine * wm.z - wi_.z};
    pairs.wi.insert(pairs.wi.end(), {wi_.x, wi_.y, wi_.z});
    pairs.wo.insert(pairs.wo.end(), {wo.x, wo.y, wo.z});
    const bool above = wo.z > kLeastCosine && cosine > 0;
    // sr of wo for a unit of the grid's square: of the axes, of the reflection, of the bend.
    const double solid = 2 * kPi * kPi * normal.u * sine * 4 * cosine / normal.density;
    const bool weighs = above && normal.density > 0;
    pairs.weights.push_back(weighs ? zone_ * x.part * y.part * solid : 0);
    const double jacobian = rgl_.jacobian ? along_theta(rgl_.ndf, normal.u) / (4 * sigma_) : 1;
    const double scale = above ? jacobian / wo.z : 0;
    const bool seen = std::max({colour[0], colour[plane], colour[2 * plane]}) > 0;
    for (std::uint64_t c = 0; c < kChannels; ++c) {
      const auto value = static_cast<double>(colour[c * plane]);
      pairs.raised += seen && value < 0 ? 1 : 0;
      pairs.values.push_back(scale * (seen ? std::max(value, 0.0) : value));
    }
  }

  const Rgl& rgl_;
  double theta_;
  Vector wi_;
  double sigma_, zone_;
  BilinearDensity normals_;
  std::span<const float> colours_;
};

}  // namespace

Result<MeasuredPairs> parse_rgl(std::string_view bytes, const std::string& name) {
  const auto file = TensorFile::parse(bytes, name);
  if (!file) return file.error();
  const auto rgl = read(*file);
  if (!rgl) return rgl.error();
  if (const auto sound = check(*rgl, *file); !sound) return sound.error();
  MeasuredPairs pairs;
  pairs.channels = kChannels;
  for (std::size_t angle = 0; angle < rgl->theta_i.values.size(); ++angle)
    Incidence(*rgl, angle).add_nodes(pairs);
  return pairs;
}

Result<MeasuredPairs> read_rgl(const std::filesystem::path& file) {
  const auto bytes = read_text_file(file, "an RGL file (.bsdf)");
  if (!bytes) return bytes.error();
  return parse_rgl(*bytes, file.string());
}

}  // namespace gonio
