#include "client/cli/local_reference.h"

#include <vector>

#include "client/cli/material_argument.h"
#include "engine/material_impl.h"
#include "measured/table.h"

namespace gonio::cli {

Result<Material> local_material(const Materials& materials, const client::Material& material) {
  auto built = materials.resolve(material.wire());
  if (!built) return built.error();
  return built->material();
}

Result<fit::Data> local_data(const Materials& materials, const MeasuredInput& input) {
  if (input.measured) {
    const auto material = local_material(materials, *input.measured);
    if (!material) return material.error();
    return fit::from_table(*material->impl().table);
  }
  const auto wide = [](const std::vector<float>& x) {
    return std::vector<double>(x.begin(), x.end());
  };
  return fit::from_pairs(wide(input.wi), wide(input.wo), wide(input.values), input.channels,
                         wide(input.weights));
}

}  // namespace gonio::cli
