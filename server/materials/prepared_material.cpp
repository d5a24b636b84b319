#include "server/materials/prepared_material.h"

namespace gonio::server {

const Sampler& PreparedMaterial::sampler() const {
  std::call_once(lazy_->once, [this] {
    lazy_->sampler = Sampler::create(material_);
    lazy_->ready = true;
  });
  return *lazy_->sampler;
}

std::size_t PreparedMaterial::bytes() const {
  return material_.bytes() + (has_sampler() ? lazy_->sampler->bytes() : 0);
}

}  // namespace gonio::server
