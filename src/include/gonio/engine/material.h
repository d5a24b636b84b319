// A material, checked and prepared for evaluation: one model, a sum of lobes, or a measured table.
//
// Build one from a MaterialSpec (what a person writes) or from a table. A Material is immutable and
// cheap to copy (it shares its data); evaluating one from many threads at once is safe.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/engine/isa.h"
#include "gonio/models/description.h"

namespace gonio {

inline constexpr int kMaxChannels = 64;
inline constexpr int kMaxSpecularLobes = 4;

// Numbers (one for all channels, or one per channel) or a word.
using ParameterValue = std::variant<std::vector<double>, std::string>;

struct LobeSpec {
  std::string model;
  std::map<std::string, ParameterValue, std::less<>> parameters;
};

// How a material's tangents lie in the frame of the directions: turned about the normal,
// counter-clockwise seen from above. f(wi, wo) of a turned material is that of the unturned one for
// both directions turned back. A number of the whole material, beside its lobes.
inline constexpr Parameter kRotation{
    .name = "rotation",
    .meaning = "of the tangents about the normal, counter-clockwise seen from above",
    .unit = "degrees",
    .lower = -180,
    .upper = 180,
    .start = 0};

// Either `model` alone, or a sum of at most one diffuse base and up to four specular lobes.
struct MaterialSpec {
  std::optional<LobeSpec> model;
  std::optional<LobeSpec> diffuse;
  std::vector<LobeSpec> specular;
  std::optional<double> rotation = {};  // degrees; see kRotation
};

// Whether a rotation is within its bounds; the error names it as `prefix` + "rotation".
Outcome check_rotation(double degrees, std::string_view prefix);

// Where the file of a measured material lies; an error for one that may not be read.
using FindFile = std::function<Result<std::filesystem::path>(const std::string& file)>;

class MeasuredTable;  // measured/table.h

enum class Interpolation : std::uint8_t {
  linear,   // between the centres of the neighbouring valid cells (the default)
  nearest,  // the cell that holds the direction pair, as the MERL database's own reader does
};

class Material {
 public:
  // Checks every name, bound and length. Errors name the field as `prefix` +
  // "specular[0].parameters.alpha_x".
  static Result<Material> create(const MaterialSpec& spec, std::string_view prefix = {});
  // A measured model as its parameters say, from the file that they name. Errors are those of
  // create(), of `find_file` and of the format's reader.
  static Result<Material> from_file(const LobeSpec& spec, std::string_view prefix,
                                    const FindFile& find_file);
  static Material from_table(std::shared_ptr<const MeasuredTable> table,
                             Interpolation interpolation);

  // Whether it can look different from other azimuths: has a model with tangents.
  [[nodiscard]] bool has_tangents() const;
  // The same material turned by so much more, -180 to 180 degrees.
  [[nodiscard]] Material turned(double degrees) const;

  [[nodiscard]] int channels() const;                     // 1 to kMaxChannels
  [[nodiscard]] ErrorBound error_bound(Precision) const;  // the worst of the parts
  [[nodiscard]] std::size_t bytes() const;                // memory held

  // For the engine.
  struct Impl;
  explicit Material(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  [[nodiscard]] const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace gonio
