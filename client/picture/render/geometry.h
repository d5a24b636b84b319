// Vectors, rays, and the local frame of a surface. The world is right-handed with z up, lengths
// have no unit. Thread safety: plain values.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace gonio::render {

using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;  // a local direction as the service takes it

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// `theta` from +z, `phi` from +x towards +y, both in radians.
inline Vec3 direction_of(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

struct Ray {
  Vec3 origin;
  Vec3 direction;  // of unit length
};

// Unit tangents u and v and the normal n, right-handed: (1,0,0), (0,1,0), (0,0,1) of client.h.
struct Frame {
  Vec3 u, v, n;

  [[nodiscard]] Vec3f to_local(const Vec3& direction) const {
    return Vec3(direction.dot(u), direction.dot(v), direction.dot(n)).cast<float>();
  }
  [[nodiscard]] Vec3 to_world(const Vec3f& local) const {
    const Vec3 w = local.cast<double>();
    return w.x() * u + w.y() * v + w.z() * n;
  }
};

}  // namespace gonio::render
