// What a model says of itself. One table per model, above its formula; validation, ListModels,
// `gonio models`, the documentation and the fitter's bounds all read it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace gonio {

enum class Role : std::uint8_t {
  diffuse,   // may stand alone and as the diffuse base of a sum
  specular,  // may stand alone and as a specular lobe of a sum
  measured,  // stands alone: a table
};

enum class Scale : std::uint8_t { linear, logarithmic };

enum class ParameterType : std::uint8_t {
  number,  // one number for all channels
  colour,  // one number, or one per channel
  word,    // one of `words`
  file,    // the name of a file of measurements; always to be given
};

// What a number is to f. A fit searches the shapes, indices and extinctions, which all channels
// share, and solves for the colours of each channel (fit/form.h).
enum class Quantity : std::uint8_t {
  by_type,           // see quantity_of(): what an ordinary parameter of its type is
  shape,             // bends or widens a lobe
  amplitude,         // a colour that multiplies a whole lobe
  reflectance,       // a colour: a lobe's reflectance, at normal incidence or at all angles
  base,              // a colour: that of a diffuse term
  refractive_index,  // that of a dielectric where no extinction is used with it
  extinction,
};

// How f, or its term that a colour belongs to, depends on that colour c. Where it is not linear the
// bounds of the colour hold 0 and 1.
enum class Dependence : std::uint8_t {
  linear,     // c A
  affine,     // c A + (1 - c) B, a reflectance that an amplitude multiplies: Schlick's
  quadratic,  // c A + c^2 B, a base colour
};

// The words of another parameter with which a number has a meaning; none: it always has.
struct UsedWith {
  std::string_view parameter = {};
  std::span<const std::string_view> words = {};
};

// A word that may stand in the place of a colour's numbers.
struct Preset {
  std::string_view name;
  std::array<double, 3> rgb;  // linear
  std::string_view source;    // publication, and what the channels stand for
};

struct Parameter {
  std::string_view name;
  std::string_view meaning;
  std::string_view unit;  // "1" for a pure number, "rad" for an angle
  double lower = 0;       // what evaluation accepts, both ends included
  double upper = 1;
  double start = 0;  // taken when the parameter is not given; a fit starts here
  Scale scale = Scale::linear;
  ParameterType type = ParameterType::number;
  // For ParameterType::word only, the default first. A word that is not given is the first one that
  // all the given numbers can be used with.
  std::span<const std::string_view> words = {};
  UsedWith used_with = {};
  std::span<const Preset> presets = {};  // for ParameterType::colour only
  // What must be given too where this is a preset: with half of its complex index, and the other
  // half's default, a conductor would be another substance.
  std::string_view preset_partner = {};
  // The rest says what a fit may do with it. An ordinary shape or colour needs none of it.
  Quantity quantity = Quantity::by_type;
  Dependence dependence = Dependence::linear;
  UsedWith dependence_with = {};  // the words with which `dependence` holds; linear with others
  // Of a base colour beside a lobe: the reflectance by which its term is dimmed, times 1 - that.
  std::string_view dimmed_by = {};
  // False for a number that reflectance does not tell: a fit holds it as given, or at its start.
  bool fitted = true;
  // Of a word: what `gonio fit` takes where it is given none; empty: the first.
  std::string_view fit_word = {};
};

// What a parameter of a model of that role is to f, where its table does not say.
constexpr Quantity quantity_of(const Parameter& p, Role role) {
  if (p.quantity != Quantity::by_type) return p.quantity;
  if (p.type != ParameterType::colour) return Quantity::shape;
  return role == Role::diffuse ? Quantity::base : Quantity::reflectance;
}

// |f - truth| <= relative * truth wherever truth > above and both n.wi and n.wo > cosine, truth
// being the formula in exact arithmetic at the exactly normalised input directions. Closer to the
// horizon (89.99994 degrees) values are still finite and not negative. `note` says where the bound
// does not hold, or is tighter; empty if it simply holds.
struct ErrorBound {
  double relative = 0;
  double above = 1e-30;
  double cosine = 1e-6;
  std::string_view note = {};
};

struct ModelDescription {
  std::string_view name;
  std::string_view summary;  // one line
  std::string_view source;   // paper and equation
  Role role = Role::specular;
  std::span<const Parameter> parameters;
  ErrorBound fast;       // float32 in and out
  ErrorBound reference;  // float64
  // The largest albedo over all directions, for colours and a scale of at most 1. Above 1 for what
  // gains energy as published; 0 where it is not known (a table).
  double albedo_limit = 1;
  // The parameters of a difference that crosses 0, where no relative bound can hold: the error may
  // be as large there as four roundings of each of them make it.
  std::span<const std::string_view> crossing = {};
  // The two parameters that belong to the tangents u and v; empty for a model that is alike along
  // all of them.
  std::array<std::string_view, 2> along_tangents = {};
  [[nodiscard]] constexpr bool has_tangents() const { return !along_tangents[0].empty(); }
};

}  // namespace gonio
