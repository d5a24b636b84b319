#include "timing/pairs.h"

#include <cmath>
#include <random>

namespace gonio::timing {
namespace {

constexpr std::size_t kRoom = 80;

template <class Out>
Batch<float, Out> batch_of(const std::array<std::vector<float>, 6>& in, std::size_t count,
                           std::vector<Out>& out) {
  return {Directions<float>::separate(in[0].data(), in[1].data(), in[2].data()),
          Directions<float>::separate(in[3].data(), in[4].data(), in[5].data()), count,
          Values<Out>::planar(out.data(), count), nullptr};
}

}  // namespace

Pairs::Pairs(std::size_t count, int channels)
    : count_(count),
      out_(static_cast<std::size_t>(channels) * count + kRoom),
      out64_(static_cast<std::size_t>(channels) * count + kRoom) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform;
  for (auto& component : in_) component.resize(count + kRoom);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 6; k += 3) {
      const float z = uniform(random) * 0.999F + 0.001F, phi = 6.2831853F * uniform(random),
                  s = std::sqrt(1 - z * z);
      in_[k][i] = s * std::cos(phi), in_[k + 1][i] = s * std::sin(phi), in_[k + 2][i] = z;
    }
  }
}

Batch<float, float> Pairs::fast() { return batch_of(in_, count_, out_); }
Batch<float, double> Pairs::reference() { return batch_of(in_, count_, out64_); }

Runner evaluation(const std::shared_ptr<Pairs>& pairs, const Material& material,
                  Precision precision, Isa isa) {
  const auto items = static_cast<double>(pairs->count());
  if (precision == Precision::fast)
    return {[pairs, material, isa] { evaluate(material, pairs->fast(), isa); }, items};
  return {[pairs, material, isa] { evaluate(material, pairs->reference(), isa); }, items};
}

}  // namespace gonio::timing
