#include <chrono>
#include <memory>
#include <utility>

#include "client/cli/arguments/material_argument.h"
#include "client/cli/arguments/render_arguments.h"
#include "client/cli/commands/commands.h"
#include "client/cli/output/exit_codes.h"
#include "client/cli/output/output_file.h"
#include "client/cli/output/progress.h"
#include "client/cli/output/summary.h"
#include "client/picture/image/exr.h"
#include "client/picture/image/png.h"
#include "client/picture/image/srgb.h"
#include "client/picture/render/evaluator.h"
#include "client/picture/render/integrator.h"
#include "server/arguments/options.h"

namespace gonio::cli {
namespace {

constexpr float kBackground = 0.05F;  // behind an object in a directional light

std::optional<render::Rgb> background_of(const RenderArguments& arguments) {
  if (arguments.background) {
    return render::Rgb::Constant(static_cast<float>(*arguments.background));
  }
  if (arguments.light == "directional") return render::Rgb::Constant(kBackground);
  return std::nullopt;
}

Result<std::string> encoded(const image::Image& picture, PictureFormat format, double exposure) {
  if (format == PictureFormat::exr) return image::encode_exr(picture);
  return image::encode_png(image::srgb_bytes(picture, exposure), picture.width, picture.height);
}

Result<image::Image> render_picture(const RenderArguments& arguments, const RenderPlan& plan,
                                    const render::Light& light, render::Evaluator& evaluator) {
  const auto shape = render::make_shape(plan.shape);
  const render::Camera camera(arguments.view, shape->radius(), plan.size.width, plan.size.height);
  const render::Scene scene{*shape, camera, light, background_of(arguments)};
  const render::Sampling sampling{plan.size.width, plan.size.height, plan.samples,
                                  arguments.seed,  plan.technique,   arguments.connection.threads};
  Progress progress(!arguments.quiet, "pairs");
  return render::render(scene, sampling, evaluator,
                        [&](double done) { progress.update(evaluator.report().pairs, done); });
}

int run(const RenderArguments& arguments) {
  auto plan = RenderPlan::of(arguments);
  if (!plan) return fail(plan.error());
  auto material = read_material(arguments.material, arguments.connection.server.empty());
  if (!material) return fail(material.error());
  auto output = OutputFile::open(arguments.output);
  if (!output) return fail(output.error());
  auto light = make_light(arguments, *plan);
  if (!light) return fail(light.error());
  auto connection = Connection::open(arguments.connection);
  if (!connection) return fail(connection.error());
  auto evaluator = render::Evaluator::create(connection->client, std::move(material).value());
  if (!evaluator) return fail(evaluator.error());

  const auto start = std::chrono::steady_clock::now();
  auto picture = render_picture(arguments, *plan, **light, *evaluator);
  if (!picture) return fail(picture.error());
  auto bytes = encoded(*picture, plan->format, arguments.exposure);
  if (!bytes) return fail(bytes.error());
  Outcome written = output->write(*bytes);
  if (written) written = output->commit();
  if (!written) return fail(written.error());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  print_summary(evaluator->report(), "pairs", taken.count(), arguments.quiet, arguments.verbose);
  return exit_ok;
}

}  // namespace

Command add_render_command(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App& command = arguments::add_command(
      app, "render", "Make a picture of an object of a material, in a light");
  add_render_options(command, *arguments);
  return {&command, [arguments] { return run(*arguments); }};
}

}  // namespace gonio::cli
