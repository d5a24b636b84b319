// The arguments of `gonio render`. Thread safety: plain values.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "client/cli/connection/connection.h"
#include "client/cli/output/picture.h"
#include "client/picture/render/camera.h"
#include "client/picture/render/integrator.h"
#include "client/picture/render/light.h"
#include "client/picture/render/shape.h"
#include "gonio/base/result.h"

namespace gonio::cli {

struct RenderArguments {
  ConnectionOptions connection;
  std::string material;
  std::string light = "directional";             // or sky, or a file
  std::string light_direction;                   // "X,Y,Z"; empty: by the angles
  std::optional<double> light_theta, light_phi;  // degrees
  std::string shape = "sphere";
  std::string size = "512x512";
  double samples = 64;
  render::View view;
  double exposure = 0;
  std::optional<double> background;
  std::string sampling = "both";  // light, surface
  std::uint32_t seed = 0;
  std::string output;
  bool quiet = false;
  bool verbose = false;
};

void add_render_options(CLI::App& command, RenderArguments& arguments);

// What the arguments say, checked. Errors name the option, its value and what is allowed.
struct RenderPlan {
  render::ShapeKind shape = render::ShapeKind::sphere;
  PictureSize size;
  PictureFormat format = PictureFormat::png;
  int samples = 1;
  render::Technique technique = render::Technique::both;
  render::Vec3 light_direction;  // of unit length; for the directional light

  static Result<RenderPlan> of(const RenderArguments& arguments);
};

// Reads the map, if it is one.
Result<std::unique_ptr<const render::Light>> make_light(const RenderArguments& arguments,
                                                        const RenderPlan& plan);

}  // namespace gonio::cli
