// A material as the server holds it: with its sampler, made when one is first asked for.
//
// Making a sampler takes up to 10 ms; most materials are only evaluated. Copies share the sampler.
// Thread safety: any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "gonio/engine/material.h"
#include "gonio/engine/sampler.h"

namespace gonio::server {

class PreparedMaterial {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): a material is one without a sampler
  PreparedMaterial(Material material) : material_(std::move(material)) {}

  [[nodiscard]] const Material& material() const { return material_; }
  // Made by the first that asks, while the others wait.
  [[nodiscard]] const Sampler& sampler() const;
  [[nodiscard]] bool has_sampler() const { return lazy_->ready; }
  [[nodiscard]] std::size_t bytes() const;  // memory held

 private:
  struct Lazy {
    std::once_flag once;
    std::optional<Sampler> sampler;
    std::atomic<bool> ready{false};
  };
  Material material_;
  std::shared_ptr<Lazy> lazy_ = std::make_shared<Lazy>();
};

}  // namespace gonio::server
