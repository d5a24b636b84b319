// From a fit's parameters to a material that a person can read.
#include <algorithm>
#include <cmath>

#include "fit/linear/basis.h"
#include "gonio/models/description.h"

namespace gonio::fit {
namespace {

using Numbers = std::vector<double>;

// One number where all are the same.
Numbers shortest(Numbers numbers) {
  if (std::all_of(numbers.begin(), numbers.end(), [&](double x) { return x == numbers[0]; }))
    numbers.resize(1);
  return numbers;
}

void set(LobeSpec& spec, const Parameter& p, Numbers numbers, bool exact) {
  for (double& x : numbers) x = exact ? x : std::clamp(x, p.lower, p.upper);
  spec.parameters[std::string(p.name)] = shortest(std::move(numbers));
}

template <class Of>
Numbers each(const std::vector<Colour>& channels, const Of& of) {
  Numbers numbers;
  for (const Colour& colour : channels) numbers.push_back(of(colour));
  return numbers;
}

void set_colours(const FormLobe& lobe, const std::vector<Colour>& channels, bool exact,
                 LobeSpec& spec) {
  const LobeColours& colours = lobe.colours;
  if (colours.columns == Columns::scaled && colours.reflectance != nullptr) {
    // What a reflectance can say, it says; the amplitude says the rest.
    const double most = colours.reflectance->upper;
    set(spec, *colours.reflectance,
        each(channels, [&](const Colour& c) { return std::min(c.scale, most); }), exact);
    set(spec, *colours.scale,
        each(channels, [&](const Colour& c) { return std::max(c.scale / most, 1.0); }), exact);
    return;
  }
  for (const ColourMember member : colours.members()) {
    set(spec, colours.parameter(member), each(channels, [&](const Colour& c) { return c.*member; }),
        exact);
  }
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
    LobeSpec made = lobe.held;
    set_shapes(form, i, shapes, made);
    std::vector<Colour> colours;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
      colours.push_back(colour_at(
          lobe, parameters.subspan(form.first_of(lobe, c), lobe.coefficient_count), basis.peaks()));
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
