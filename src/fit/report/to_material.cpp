// From a fit's parameters to a material that a person can read.
#include <algorithm>
#include <cmath>

#include "fit/linear/basis.h"
#include "gonio/engine/registry.h"

namespace gonio::fit {
namespace {

using Numbers = std::vector<double>;

// One number where all are the same.
Numbers shortest(Numbers numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [&](double x) { return x == numbers[0]; }))
    numbers.resize(1);
  return numbers;
}

const Parameter& parameter_of(const std::string& model, std::string_view name) {
  const auto& parameters = (*find_model(model))->parameters;
  return *std::find_if(parameters.begin(), parameters.end(),
                       [&](const Parameter& p) { return p.name == name; });
}

void set(LobeSpec& spec, std::string_view name, Numbers numbers, bool exact) {
  const Parameter& p = parameter_of(spec.model, name);
  for (double& x : numbers) x = exact ? x : std::clamp(x, p.lower, p.upper);
  spec.parameters[std::string(name)] = shortest(std::move(numbers));
}

template <class Of>
Numbers each(const std::vector<Colour>& channels, const Of& of) {
  Numbers numbers;
  for (const Colour& colour : channels) numbers.push_back(of(colour));
  return numbers;
}

void set_colours(const FormLobe& lobe, const std::vector<Colour>& channels, bool exact,
                 LobeSpec& spec) {
  if (lobe.columns == Columns::reflectance) {
    // What a reflectance can say, it says; the scale says the rest.
    set(spec, "rs", each(channels, [](const Colour& c) { return std::min(c.scale, 1.0); }), exact);
    set(spec, "scale", each(channels, [](const Colour& c) { return std::max(c.scale, 1.0); }),
        exact);
    return;
  }
  for (const ColourMember member : members_of(lobe.columns, lobe.coefficient_count)) {
    set(spec, name_of(lobe.columns, member),
        each(channels, [&](const Colour& c) { return c.*member; }), exact);
  }
  // In a sum a lobe has no diffuse term of its own.
  if (lobe.columns == Columns::ashikhmin_shirley && lobe.coefficient_count < 3)
    set(spec, "rd", {0}, exact);
}

}  // namespace

MaterialSpec to_material(const Form& form, std::span<const double> parameters, int channels,
                         bool exact) {
  const auto shapes = parameters.first(form.shapes.size());
  const BasisAt basis(form, shapes, false);
  MaterialSpec spec;
  spec.rotation = rotation_of(form, shapes);
  for (std::size_t i = 0; i < form.lobes.size(); ++i) {
    const FormLobe& lobe = form.lobes[i];
    LobeSpec made = lobe.words;
    set_shapes(form, i, shapes, made);
    std::vector<Colour> colours;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
      const std::size_t first = form.shapes.size() + c * form.coefficients + lobe.first_coefficient;
      colours.push_back(
          colour_at(lobe, parameters.subspan(first, lobe.coefficient_count), basis.peaks()));
      colours.back().scale *= form.unit;
      colours.back().diffuse *= form.unit;
    }
    set_colours(lobe, colours, exact, made);
    if (lobe.alone) {
      spec.model = std::move(made);
    } else if (lobe.prefix == "diffuse.") {
      spec.diffuse = std::move(made);
    } else {
      spec.specular.push_back(std::move(made));
    }
  }
  return spec;
}

}  // namespace gonio::fit
