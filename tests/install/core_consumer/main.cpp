// A program of someone else's that evaluates in its own process.
#include <gonio/base/version.h>
#include <gonio/engine/evaluate.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

int main() {
  const gonio::LobeSpec paper{"lambertian", {{"rd", std::vector{0.5}}}};
  const auto material = gonio::Material::create({.model = paper});
  if (!material.ok()) return std::puts(material.error().message.c_str()), 1;

  const std::vector<float> wi = {0, 0, 1, 0.6f, 0, 0.8f}, wo = {0, 0, 1, 0, -0.6f, 0.8f};
  std::vector<float> f(2);
  gonio::Batch<float, float> batch;
  batch.wi = gonio::Directions<float>::interleaved(wi.data());
  batch.wo = gonio::Directions<float>::interleaved(wo.data());
  batch.count = f.size();
  batch.values = gonio::Values<float>::interleaved(f.data(), 1);
  const auto flags = gonio::evaluate(*material, batch, gonio::best_isa());

  std::printf("gonio %s: f = %g, %g\n", gonio::kVersion, f[0], f[1]);
  const float truth = 0.5f * std::numbers::inv_pi_v<float>;
  const bool right = flags == 0 && std::abs(f[0] - truth) < 1e-6f && std::abs(f[1] - truth) < 1e-6f;
  return right ? 0 : 1;
}
