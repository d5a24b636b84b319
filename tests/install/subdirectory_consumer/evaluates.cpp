#include <gonio/engine/evaluate.h>
#include <gonio/engine/material.h>
#include <gonio/engine/sampler.h>
#include <gonio/measured/table.h>

bool is_a_material(const gonio::LobeSpec& lobe) {
  return gonio::Material::create({.model = lobe}).ok();
}
