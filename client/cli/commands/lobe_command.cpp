#include <filesystem>
#include <memory>
#include <utility>

#include "client/cli/arguments/common_arguments.h"
#include "client/cli/arguments/material_argument.h"
#include "client/cli/commands/commands.h"
#include "client/cli/connection/connection.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/output_file.h"
#include "client/cli/output/picture.h"
#include "client/picture/image/png.h"
#include "client/picture/lobe/picture.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kMostAngles = 8;
constexpr int kLeastSide = 100;  // what is smaller cannot be read

constexpr const char* kFooter = R"(
For each angle of incidence, in a column: above, the BRDF in the plane of incidence, its length on the scale (three
lines for red, green and blue), with the light from the left, the mirror's direction dashed; below, the
hemisphere seen from above, the cosines as they are, in false colours of the luminance. One scale for all.

Examples:
  gonio lobe --material copper.json --theta 30,60,80 -o lobe.png
  gonio lobe --material '{"model": "oren_nayar"}' --theta 75 --scale linear --cosine -o diffuse.png)";

struct LobeArguments {
  ConnectionOptions connection;
  std::string material;
  std::vector<double> theta;
  std::string size;
  std::string scale = "log";
  std::string output;
  double phi = 180;
  bool cosine = false;
};

void add_lobe_options(CLI::App& command, LobeArguments& arguments) {
  arguments::set_footer(command, kFooter);
  add_material_option(command, arguments.material,
                      "What to show: JSON, a file or a stored name, as for 'gonio evaluate'");
  arguments::add_option(
      command, "--theta", arguments.theta,
      "Angles of incidence from the normal, degrees, each from 0 to below 90; up to 8")
      .type_name("DEG,...")
      .delimiter(',')
      .required();
  arguments::add_option(
      command, "--phi", arguments.phi,
      "The light's azimuth from u towards v, degrees, -360 to 360; 180 if not given: "
      "the tangent u is on the right")
      .type_name("DEG");
  arguments::add_option(
      command, "--scale", arguments.scale,
      "Of lengths and colours: log (the default, two to six decades), linear, or cbrt")
      .type_name("S")
      .one_of({"log", "linear", "cbrt"});
  arguments::add_flag(command, "--cosine", arguments.cosine, "Show f cos(theta_o) in place of f");
  arguments::add_option(command, "--size", arguments.size,
                        "Pixels, 100x100 to 8192x8192; else to suit the number of angles")
      .type_name("WxH");
  arguments::add_option(command, "-o,--output", arguments.output,
                        "The picture: a file that ends in .png")
      .type_name("OUT")
      .required();
  add_connection_options(command, arguments.connection);
}

Outcome check_angles(const LobeArguments& arguments) {
  if (arguments.theta.size() > kMostAngles) {
    return bad_value("--theta", std::to_string(arguments.theta.size()) + " angles",
                     "1 to " + std::to_string(kMostAngles));
  }
  for (const double theta : arguments.theta) {
    if (theta >= 0 && theta < 90) continue;
    return bad_value("--theta", shortest(theta), "0 to below 90 degrees");
  }
  return check_range("--phi", arguments.phi, -360, 360);
}

Result<lobe::PictureOptions> picture_options(const LobeArguments& arguments) {
  if (auto good = check_angles(arguments); !good) return good.error();
  auto format = picture_format(arguments.output);
  if (!format || *format != PictureFormat::png) {
    return bad_value("-o", "\"" + arguments.output + "\"", "a file that ends in .png");
  }
  lobe::PictureOptions options;
  const int columns = static_cast<int>(arguments.theta.size());
  PictureSize size{390 * columns + 120, 690};
  if (!arguments.size.empty()) {
    auto given = parse_size(arguments.size, kLeastSide);
    if (!given) return given.error();
    size = *given;
  }
  options.width = size.width;
  options.height = size.height;
  // Of a file its name, of JSON or a stored material all of it.
  const bool inline_json = arguments.material.find('{') != std::string::npos;
  options.title = inline_json ? arguments.material
                              : std::filesystem::path(arguments.material).filename().string();
  options.theta_i = arguments.theta;
  options.phi_i = arguments.phi;
  options.cosine = arguments.cosine;
  options.scale = arguments.scale == "linear" ? lobe::ScaleKind::linear
                  : arguments.scale == "cbrt" ? lobe::ScaleKind::cbrt
                                              : lobe::ScaleKind::log;
  return options;
}

int run(const LobeArguments& arguments) {
  auto options = picture_options(arguments);
  if (!options) return fail(options.error());
  auto material = read_material(arguments.material, arguments.connection.server.empty());
  if (!material) return fail(material.error());
  auto output = OutputFile::open(arguments.output);
  if (!output) return fail(output.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  auto evaluator = render::Evaluator::create(connection->client, std::move(material).value());
  if (!evaluator) return fail(evaluator.error());
  auto rgb = lobe::draw_lobes(*options, *evaluator);
  if (!rgb) return fail(rgb.error());
  auto bytes = image::encode_png(*rgb, options->width, options->height);
  if (!bytes) return fail(bytes.error());
  const Outcome written = output->write_whole(*bytes);
  return written ? exit_ok : fail(written.error());
}

}  // namespace

Command add_lobe_command(CLI::App& app) {
  auto arguments = std::make_shared<LobeArguments>();
  CLI::App& command = arguments::add_command(
      app, "lobe", "Draw how a material distributes the light that it reflects");
  add_lobe_options(command, *arguments);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
