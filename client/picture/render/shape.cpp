#include "client/picture/render/shape.h"

#include <cmath>
#include <limits>

namespace gonio::render {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// u along the circle around the z axis through `position`.
Frame around_axis(const Vec3& position, const Vec3& normal) {
  const double distance = std::hypot(position.x(), position.y());
  const Vec3 u =
      distance > 0 ? Vec3(-position.y() / distance, position.x() / distance, 0) : Vec3::UnitX();
  return {u, normal.cross(u), normal};
}

// The smaller root of a t^2 + 2 b t + c, or kNone.
double first_root(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (a <= 0 || discriminant < 0) return kNone;
  return (-b - std::sqrt(discriminant)) / a;
}

class Sphere : public Shape {
 public:
  [[nodiscard]] std::optional<Frame> hit(const Ray& ray) const override {
    const double b = ray.origin.dot(ray.direction);
    const double t = first_root(1, b, ray.origin.squaredNorm() - 1);
    if (!(t > 0) || t == kNone) return std::nullopt;
    const Vec3 normal = (ray.origin + t * ray.direction).normalized();
    return around_axis(normal, normal);
  }
  [[nodiscard]] double radius() const override { return 1; }
};

// In its own coordinates, its axis is z.
class Cylinder : public Shape {
 public:
  [[nodiscard]] std::optional<Frame> hit(const Ray& ray) const override {
    const auto frame =
        hit_upright({own_.transpose() * ray.origin, own_.transpose() * ray.direction});
    if (!frame) return std::nullopt;
    return Frame{own_ * frame->u, own_ * frame->v, own_ * frame->n};
  }
  [[nodiscard]] double radius() const override { return std::hypot(kRadius, kHalfLength); }

 private:
  static constexpr double kRadius = 0.6, kHalfLength = 0.9, kTurn = 20;  // the turn in degrees

  static std::optional<Frame> hit_upright(const Ray& ray) {
    // Of the two ends only the one that the ray looks at can be met from outside.
    const double end = std::copysign(kHalfLength, -ray.direction.z());
    const double to_end =
        ray.direction.z() == 0 ? kNone : (end - ray.origin.z()) / ray.direction.z();
    if (to_end > 0 && to_end < kNone) {
      const Vec3 on_end = ray.origin + to_end * ray.direction;
      if (std::hypot(on_end.x(), on_end.y()) <= kRadius) {
        return around_axis(on_end, Vec3(0, 0, std::copysign(1.0, end)));
      }
    }
    const auto origin = ray.origin.head<2>(), direction = ray.direction.head<2>();
    const double t = first_root(direction.squaredNorm(), origin.dot(direction),
                                origin.squaredNorm() - kRadius * kRadius);
    if (!(t > 0) || t == kNone) return std::nullopt;
    const Vec3 on_side = ray.origin + t * ray.direction;
    if (std::abs(on_side.z()) > kHalfLength) return std::nullopt;
    return around_axis(on_side, Vec3(on_side.x(), on_side.y(), 0).normalized());
  }

  static Eigen::Matrix3d own_axes() {
    Eigen::Matrix3d axes;
    axes.col(2) = direction_of(std::numbers::pi / 2, radians(kTurn));
    axes.col(0) = Vec3::UnitZ();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return axes;
  }

  const Eigen::Matrix3d own_ = own_axes();
};

class Plane : public Shape {
 public:
  [[nodiscard]] std::optional<Frame> hit(const Ray& ray) const override {
    if (!(ray.direction.z() < 0 && ray.origin.z() > 0)) return std::nullopt;
    const Vec3 at = ray.origin - ray.origin.z() / ray.direction.z() * ray.direction;
    if (std::abs(at.x()) > 1 || std::abs(at.y()) > 1) return std::nullopt;
    return Frame{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  }
  [[nodiscard]] double radius() const override { return std::numbers::sqrt2; }
};

}  // namespace

std::unique_ptr<const Shape> make_shape(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::cylinder:
      return std::make_unique<Cylinder>();
    case ShapeKind::plane:
      return std::make_unique<Plane>();
    case ShapeKind::sphere:
      break;
  }
  return std::make_unique<Sphere>();
}

}  // namespace gonio::render
