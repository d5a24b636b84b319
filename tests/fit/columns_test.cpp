// What the tables say of colours is so: the columns of a form, times the coefficients that follow
// from the colours, add up to what the material reflects.
#include "fit/linear/columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fit/registry_cases.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;

// Of one channel; 1 for what the lobe has not, or the case does not give.
double number_of(const LobeSpec& lobe, const Parameter* p, std::size_t channel) {
  const auto found = p == nullptr ? lobe.parameters.end() : lobe.parameters.find(p->name);
  if (found == lobe.parameters.end()) return 1;
  const auto& numbers = std::get<Numbers>(found->second);
  return numbers[numbers.size() == 1 ? 0 : channel];
}

Numbers shapes_of(const fit::Form& form, MaterialSpec truth) {
  Numbers shapes;
  for (const fit::ShapeParameter& shape : form.shapes) {
    const auto& given = lobe_at(truth, shape.lobe).parameters.at(shape.names.front());
    shapes.push_back(shape.scale.to_search(std::get<Numbers>(given)[0]));
  }
  return shapes;
}

Numbers coefficients_of(const fit::Form& form, MaterialSpec truth, std::size_t channel,
                        const Numbers& peaks) {
  Numbers all;
  for (std::size_t i = 0; i < form.lobes.size(); ++i) {
    const fit::FormLobe& lobe = form.lobes[i];
    const LobeSpec& spec = lobe_at(truth, i);
    fit::Colour colour{number_of(spec, lobe.colours.scale, channel),
                       number_of(spec, lobe.colours.reflectance, channel),
                       number_of(spec, lobe.colours.diffuse, channel)};
    if (lobe.colours.columns == fit::Columns::scaled) colour.scale *= colour.reflectance;
    const auto relative = fit::coefficients_of(lobe.colours.columns, colour);
    for (std::size_t k = 0; k < lobe.coefficient_count; ++k)
      all.push_back(relative[k] * peaks[lobe.first_column + k]);
  }
  return all;
}

class RegistryColumns : public ::testing::TestWithParam<Case> {};

TEST_P(RegistryColumns, AddUpToTheMaterial) {
  const MaterialSpec& truth = GetParam().truth;
  const fit::Form form = *fit::make_form(form_of(truth), {GetParam().anisotropic});
  const fit::Data data = data_of(truth, scattered_pairs(200, 1));
  const Numbers shapes = shapes_of(form, truth);
  const fit::BasisAt at(form, shapes, false);
  fit::Basis basis;
  at.evaluate(data, 0, data.size(), basis);
  for (int c = 0; c < data.channels; ++c) {
    Eigen::ArrayXd f;
    const Numbers coefficients =
        coefficients_of(form, truth, static_cast<std::size_t>(c), at.peaks());
    fit::sum_columns(form, basis, data.size(), coefficients, f);
    const auto measured = data.channel(c);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const double m = static_cast<double>(measured[i]);
      ASSERT_NEAR(f[static_cast<Eigen::Index>(i)], m, 1e-5 * m + 1e-12) << "pair " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, RegistryColumns, ::testing::ValuesIn(registry_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace gonio::testing
