#include "client/cli/compare/compare_pictures.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>

#include "client/cli/report/slices.h"
#include "client/picture/image/png.h"
#include "client/picture/image/srgb.h"
#include "client/picture/lobe/panel.h"
#include "client/picture/lobe/slices.h"
#include "client/picture/render/evaluator.h"
#include "client/picture/render/integrator.h"
#include "client/picture/render/sky.h"

namespace gonio::cli {
namespace {

constexpr int kPanelWidth = 460, kPanelHeight = 300, kAround = 100;  // of slices
constexpr int kSphere = 260, kGap = 8, kTitle = 34, kLine = 26;      // of spheres
constexpr int kSamples = 64;
constexpr double kText = 14;

struct LightOfRow {
  const char* name;
  std::unique_ptr<const render::Light> light;
  std::optional<render::Rgb> background;
};

Result<std::vector<LightOfRow>> lights() {
  std::vector<LightOfRow> rows;
  rows.push_back(
      {"one directional light",
       render::directional_light(render::direction_of(render::radians(45), render::radians(-60))),
       render::Rgb::Constant(0.05F)});
  auto sky = render::dome_light(render::sky_map(), "sky");
  if (!sky) return sky.error();
  rows.push_back({"a hazy sky", std::move(*sky), std::nullopt});
  return rows;
}

Result<std::vector<std::uint8_t>> sphere_of(const client::Client& client,
                                            const client::Material& material,
                                            const LightOfRow& row) {
  auto evaluator = render::Evaluator::create(client, material);
  if (!evaluator) return evaluator.error();
  const auto shape = render::make_shape(render::ShapeKind::sphere);
  const render::Camera camera({}, shape->radius(), kSphere, kSphere);
  const render::Scene scene{*shape, camera, *row.light, row.background};
  render::Sampling sampling;
  sampling.width = sampling.height = kSphere;
  sampling.samples = kSamples;
  const auto image = render::render(scene, sampling, *evaluator, [](double) {});
  if (!image) return image.error();
  return image::srgb_bytes(*image, 0);
}

Result<std::string> png_of(Result<std::vector<std::uint8_t>> rgb, int width, int height) {
  if (!rgb) return rgb.error();
  return image::encode_png(*rgb, width, height);
}

}  // namespace

Result<std::string> slices_png(const std::string& title, const fit::Data& data,
                               const std::vector<Compared>& compared) {
  lobe::SlicesPicture picture;
  std::vector<Material> materials;
  for (const Compared& one : compared) {
    picture.materials.push_back(one.name);
    materials.push_back(one.material);
  }
  const auto slices = slices_of(data, materials);
  if (!slices) return slices.error();
  picture.title = title;
  picture.columns = slices->columns;
  const auto rows = static_cast<int>(slices->panels.size() / slices->columns);
  picture.width = kPanelWidth * std::max(2, static_cast<int>(slices->columns));
  picture.height = kPanelHeight * rows + kAround;
  return png_of(lobe::draw_slices(picture, slices->panels), picture.width, picture.height);
}

Result<std::string> spheres_png(const std::string& title, const client::Client& client,
                                const client::Material& measured,
                                const std::vector<Compared>& compared) {
  const auto rows = lights();
  if (!rows) return rows.error();
  const auto columns = static_cast<int>(compared.size()) + 1;
  const int width = columns * (kSphere + kGap) + kGap;
  const int height = kTitle + static_cast<int>(rows->size()) * (kSphere + kLine);
  lobe::Canvas canvas(width, height);
  canvas.text({kGap, kTitle / 2.0}, canvas.shortened(title, 1.15 * kText, width - 2 * kGap),
              1.15 * kText, lobe::Align::left, lobe::kInk);
  for (int column = 0; column < columns; ++column) {
    const Compared* one = column == 0 ? nullptr : &compared[static_cast<std::size_t>(column - 1)];
    const int left = kGap + column * (kSphere + kGap);
    int top = kTitle;
    for (const LightOfRow& row : *rows) {
      const auto rgb = sphere_of(client, one == nullptr ? measured : one->asked, row);
      if (!rgb) return rgb.error();
      canvas.picture(left, top, kSphere, *rgb);
      const std::string name = one == nullptr ? std::string("measured, ") + row.name : one->name;
      canvas.text({left + kSphere / 2.0, top + kSphere + kLine / 2.0},
                  canvas.shortened(name, kText, kSphere), kText, lobe::Align::centre, lobe::kInk);
      top += kSphere + kLine;
    }
  }
  return png_of(canvas.rgb(), width, height);
}

}  // namespace gonio::cli
