#include "client/cli/arguments/render_arguments.h"

#include <array>
#include <cmath>
#include <string_view>

#include "base/near_names.h"
#include "client/cli/arguments/common_arguments.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/output/numbers.h"
#include "client/picture/image/read.h"
#include "client/picture/render/sky.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

using render::ShapeKind;
using render::Technique;
using render::Vec3;

constexpr int kMostSamples = 65536;
constexpr double kMostStops = 32;  // of exposure, either way
constexpr double kDefaultTheta = 45, kDefaultPhi = -60;

constexpr const char* kFooter = R"(
The world has z up; the camera stands towards -y and sees +x on its right.

Shapes:
  sphere    radius 1; tangent u along the parallels (east), v along the meridians (north)
  cylinder  lying, radius 0.6, length 1.8; u around it, v along its axis; on its ends u along the circles
  plane     2 x 2 at z = 0, seen from above; u = x, v = y

Lights:
  directional  from one direction; a white diffuse surface that faces it has radiance 1
  sky          a hazy sky, its sun behind clouds on the left behind the camera, over grey ground
  FILE         a latitude-longitude map, .exr (R, G, B or Y) or .pfm, of radiance: its upper edge is +z, its
               middle what the camera looks at. NaN, infinite and negative texels are refused

Direct light only, by Monte Carlo: SPP samples a pixel, each with one direction drawn from the light and, for
maps and the sky, one drawn by the service for the material; --sampling leaves one of them out. The same seed
gives the same picture, whatever the threads. Materials of 1 channel (grey) or 3 (red, green, blue: Rec. 709, linear).

Output: .png, 8 bits, sRGB, exposed; .exr, float32, linear radiance, without exposure. The file is written as a
whole or not at all.

Examples:
  gonio render --material gold.json --light sky --shape cylinder -o gold.png
  gonio render --material brushed.json --light-direction=-1,-1,2 --size 800x600 --spp 256 -o brushed.exr
  gonio render --server unix:/run/gonio.sock --material copper --light studio.exr --exposure 1.5 -o copper.png)";

Result<Vec3> parse_direction(const std::string& text) {
  std::array<double, 3> numbers{};
  std::string_view rest = text;
  bool good = true;
  for (std::size_t i = 0; i < 3 && good; ++i) {
    const auto comma = rest.find(',');
    const auto number = parse_number<double>(rest.substr(0, comma));
    good = number && std::isfinite(*number) && (comma == std::string_view::npos) == (i == 2);
    if (good) numbers[i] = *number;
    if (good && i < 2) rest.remove_prefix(comma + 1);
  }
  const Vec3 direction(numbers[0], numbers[1], numbers[2]);
  if (good && direction.stableNorm() > 0) return direction.stableNormalized();
  return bad_value("--light-direction", "\"" + text + "\"", "X,Y,Z: finite and not all 0");
}

Result<Vec3> to_light(const RenderArguments& arguments) {
  const bool angles = arguments.light_theta || arguments.light_phi;
  const bool given = angles || !arguments.light_direction.empty();
  if (given && arguments.light != "directional") {
    return bad_value("--light", "\"" + arguments.light + "\", with the direction of a light",
                     "directional, or no --light-direction, --light-theta, --light-phi");
  }
  if (!arguments.light_direction.empty()) return parse_direction(arguments.light_direction);
  const double theta = arguments.light_theta.value_or(kDefaultTheta);
  const double phi = arguments.light_phi.value_or(kDefaultPhi);
  if (auto good = check_range("--light-theta", theta, 0, 180); !good) return good.error();
  if (auto good = check_range("--light-phi", phi, -360, 360); !good) return good.error();
  return render::direction_of(render::radians(theta), render::radians(phi));
}

Outcome check_numbers(const RenderArguments& arguments) {
  struct Bounds {
    const char* option;
    double value, lower, upper;
  };
  for (const Bounds& bounds : {Bounds{"--spp", arguments.samples, 1, kMostSamples},
                               Bounds{"--view-elevation", arguments.view.elevation, -90, 90},
                               Bounds{"--field-of-view", arguments.view.field_of_view, 0, 120},
                               Bounds{"--zoom", arguments.view.zoom, 0.1, 1000},
                               Bounds{"--exposure", arguments.exposure, -kMostStops, kMostStops},
                               Bounds{"--background", arguments.background.value_or(0), 0, 1e6}}) {
    auto good = check_range(bounds.option, bounds.value, bounds.lower, bounds.upper);
    if (!good) return good;
  }
  if (arguments.samples == std::floor(arguments.samples)) return Ok{};
  return bad_value("--spp", shortest(arguments.samples), "a whole number");
}

template <class Value>
arguments::Option add(CLI::App& command, const char* name, Value& value, const char* unit,
                      const char* text) {
  return arguments::add_option(command, name, value, text).type_name(unit);
}

void add_light_options(CLI::App& command, RenderArguments& arguments) {
  add(command, "--light", arguments.light, "L",
      "directional (the default), sky, or a map FILE.exr or FILE.pfm");
  const arguments::Option direction = add(command, "--light-direction", arguments.light_direction,
                                          "X,Y,Z", "To the directional light; also from below");
  for (const arguments::Option& angle :
       {add(command, "--light-theta", arguments.light_theta, "DEG",
            "In its place: the angle from +z, 0 to 180; else 45"),
        add(command, "--light-phi", arguments.light_phi, "DEG",
            "and that from +x towards +y, -360 to 360; else -60")}) {
    angle.excludes(direction);
  }
}

}  // namespace

void add_render_options(CLI::App& command, RenderArguments& arguments) {
  arguments::set_footer(command, kFooter);
  add_material_option(
      command, arguments.material,
      "What the object is made of: JSON, a file or a stored name, as for 'gonio evaluate'");
  add_light_options(command, arguments);
  add(command, "--shape", arguments.shape, "S", "sphere (the default), cylinder, or plane")
      .one_of({"sphere", "cylinder", "plane"});
  add(command, "--size", arguments.size, "WxH", "Pixels, 1x1 to 8192x8192; 512x512 if not given");
  add(command, "--spp", arguments.samples, "N", "Samples a pixel, 1 to 65536; 64 if not given");
  add(command, "--view-elevation", arguments.view.elevation, "DEG",
      "How high the camera stands, -90 to 90; 20 if not given");
  add(command, "--field-of-view", arguments.view.field_of_view, "DEG",
      "Across the shorter side, to 120; 0 is orthographic; 30 if not given");
  add(command, "--zoom", arguments.view.zoom, "X",
      "Enlarges the middle of the picture, 0.1 to 1000; 1 if not given");
  add(command, "--background", arguments.background, "L",
      "A constant radiance; else 0.05, and for sky and maps what they show there");
  add(command, "--exposure", arguments.exposure, "EV",
      "Stops, for PNG: the radiance 2^-EV becomes white; -32 to 32, 0 if not given");
  add(command, "--sampling", arguments.sampling, "S",
      "Draw directions from both (the default), the light, or the surface")
      .one_of({"both", "light", "surface"});
  add(command, "--seed", arguments.seed, "S", "Of the samples, 0 to 4294967295; 0 if not given");
  add(command, "-o,--output", arguments.output, "OUT",
      "The picture: a file that ends in .png or .exr")
      .required();
  add_connection_options(command, arguments.connection);
  arguments::add_flag(command, "--quiet,-q", arguments.quiet,
                      "No progress bar and no summary of flagged pairs");
  arguments::add_flag(command, "--verbose,-v", arguments.verbose,
                      "Report time, speed, instruction set and accuracy on stderr");
}

Result<RenderPlan> RenderPlan::of(const RenderArguments& arguments) {
  RenderPlan plan;
  auto format = picture_format(arguments.output);
  if (!format) return format.error();
  auto size = parse_size(arguments.size, 1);
  if (!size) return size.error();
  if (auto good = check_numbers(arguments); !good) return good.error();
  auto direction = to_light(arguments);
  if (!direction) return direction.error();
  plan.shape = arguments.shape == "cylinder" ? ShapeKind::cylinder
               : arguments.shape == "plane"  ? ShapeKind::plane
                                             : ShapeKind::sphere;
  plan.technique = arguments.sampling == "light"     ? Technique::light
                   : arguments.sampling == "surface" ? Technique::surface
                                                     : Technique::both;
  plan.format = *format;
  plan.size = *size;
  plan.samples = static_cast<int>(arguments.samples);
  plan.light_direction = *direction;
  return plan;
}

Result<std::unique_ptr<const render::Light>> make_light(const RenderArguments& arguments,
                                                        const RenderPlan& plan) {
  if (arguments.light == "directional") return render::directional_light(plan.light_direction);
  if (arguments.light == "sky") return render::dome_light(render::sky_map(), "sky");
  const std::string extension = extension_of(arguments.light);
  if (extension != ".exr" && extension != ".pfm") {
    constexpr std::array<std::string_view, 2> kLights{"directional", "sky"};
    return bad_value("--light", "\"" + arguments.light + "\"",
                     "directional, sky, or a file that ends in .exr or .pfm" +
                         did_you_mean(arguments.light, kLights));
  }
  auto map = image::read(arguments.light);
  if (!map) return map.error();
  return render::dome_light(std::move(map).value(), arguments.light);
}

}  // namespace gonio::cli
