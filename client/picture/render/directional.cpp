#include <numbers>

#include "client/picture/render/light.h"

namespace gonio::render {
namespace {

class Directional : public Light {
 public:
  explicit Directional(const Vec3& direction) : direction_(direction) {}

  [[nodiscard]] Rgb radiance(const Vec3& /*direction*/) const override {
    return Rgb::Constant(std::numbers::pi_v<float>);
  }
  [[nodiscard]] Vec3 sample(const Xi& /*xi*/) const override { return direction_; }
  [[nodiscard]] double density(const Vec3& /*direction*/) const override { return 1; }
  [[nodiscard]] bool single_direction() const override { return true; }

 private:
  Vec3 direction_;
};

}  // namespace

std::unique_ptr<const Light> directional_light(const Vec3& direction) {
  return std::make_unique<Directional>(direction);
}

}  // namespace gonio::render
