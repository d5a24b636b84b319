#include "client/cli/local_reference.h"

#include <vector>

#include "client/cli/material_argument.h"
#include "client/cli/measured_input.h"
#include "engine/material_impl.h"
#include "measured/table.h"

namespace gonio::cli {

Result<Material> local_material(const Materials& materials, const std::string& argument) {
  const auto material = read_material(argument, true);
  if (!material) return material.error();
  auto built = materials.resolve(material->wire());
  if (!built) return built.error();
  return built->material();
}

Result<fit::Data> local_data(const Materials& materials, const std::string& file, bool degrees) {
  const auto input = read_measured(file, true, degrees);
  if (!input) return input.error();
  if (input->measured) {
    const auto material = materials.resolve(input->measured->wire());
    if (!material) return material.error();
    return fit::from_table(*material->material().impl().table);
  }
  const auto wide = [](const std::vector<float>& x) {
    return std::vector<double>(x.begin(), x.end());
  };
  return fit::from_pairs(wide(input->wi), wide(input->wo), wide(input->values), input->channels,
                         wide(input->weights));
}

}  // namespace gonio::cli
