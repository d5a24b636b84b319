// From a fit's parameters to a material that a person can read.
#include <algorithm>
#include <cmath>

#include "fit/basis.h"
#include "gonio/engine/registry.h"

namespace gonio::fit {
namespace {

using Columns = FormLobe::Columns;
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

// Each channel's coefficients of one lobe as colours.
class Colours {
 public:
  Colours(const FormLobe& lobe, int channels, std::vector<std::string>* clamped)
      : lobe_(lobe), channels_(static_cast<std::size_t>(channels)), clamped_(clamped) {}

  template <class Of>
  void set(LobeSpec& spec, const char* name, const Of& of) const {
    const Parameter& p = parameter_of(lobe_.words.model, name);
    Numbers numbers;
    bool moved = false;
    for (std::size_t c = 0; c < channels_; ++c) {
      const double x = of(c);
      numbers.push_back(std::clamp(x, p.lower, p.upper));
      moved = moved || numbers.back() != x;
    }
    if (moved && clamped_ != nullptr)
      clamped_->push_back(lobe_.prefix + "parameters." + std::string(name));
    spec.parameters[name] = shortest(std::move(numbers));
  }

 private:
  const FormLobe& lobe_;
  std::size_t channels_;
  std::vector<std::string>* clamped_;
};

// scale and f0 from scale f0 and scale (1 - f0); without a lobe, no reflectance.
double reflectance(double at_normal, double rest) {
  return at_normal + rest > 0 ? at_normal / (at_normal + rest) : 0;
}

template <class Coefficient>
void set_colours(const FormLobe& lobe, const Colours& colours, const Coefficient& x,
                 LobeSpec& spec) {
  const auto reflected = [&](std::size_t c) { return reflectance(x(c, 0), x(c, 1)); };
  const auto sum = [&](std::size_t c) { return x(c, 0) + x(c, 1); };
  switch (lobe.columns) {
    case Columns::diffuse:
    case Columns::quadratic_diffuse:
      colours.set(spec, "rd", [&](std::size_t c) { return x(c, 0); });
      break;
    case Columns::scaled:
      colours.set(spec, "scale", [&](std::size_t c) { return x(c, 0); });
      break;
    case Columns::reflectance:
      // What a reflectance can say, it says; the scale says the rest.
      colours.set(spec, "rs", [&](std::size_t c) { return std::min(x(c, 0), 1.0); });
      colours.set(spec, "scale", [&](std::size_t c) { return std::max(x(c, 0), 1.0); });
      break;
    case Columns::schlick:
      colours.set(spec, "f0", reflected);
      colours.set(spec, "scale", sum);
      break;
    case Columns::ashikhmin_shirley:
      colours.set(spec, "rs", reflected);
      colours.set(spec, "scale", sum);
      colours.set(spec, "rd", [&](std::size_t c) {
        if (lobe.coefficient_count < 3) return 0.0;
        const double rest = 1 - reflected(c);
        return x(c, 2) > 0 ? x(c, 2) / std::max(rest, 1e-300) : 0.0;
      });
      break;
  }
}

}  // namespace

MaterialSpec to_material(const Form& form, std::span<const double> parameters, int channels,
                         std::vector<std::string>* clamped) {
  const auto shapes = parameters.first(form.shapes.size());
  const BasisAt basis(form, shapes, false);
  MaterialSpec spec;
  spec.rotation = rotation_of(form, shapes);
  for (std::size_t i = 0; i < form.lobes.size(); ++i) {
    const FormLobe& lobe = form.lobes[i];
    LobeSpec made = lobe.words;
    set_shapes(form, i, shapes, made);
    const auto coefficient = [&](std::size_t c, std::size_t k) {
      const std::size_t at =
          form.shapes.size() + c * form.coefficients + lobe.first_coefficient + k;
      return parameters[at] / basis.peaks()[lobe.first_column + k];
    };
    set_colours(lobe, Colours(lobe, channels, clamped), coefficient, made);
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
