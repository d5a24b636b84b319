// A material, checked and prepared for evaluation: one model, a sum of lobes, or a measured table.
//
// Build one from a MaterialSpec (what a person writes) or from a table. A Material is immutable and
// cheap to copy (it shares its data); evaluating one from many threads at once is safe.
#pragma once

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

// Either `model` alone, or a sum of at most one diffuse base and up to four specular lobes.
struct MaterialSpec {
  std::optional<LobeSpec> model;
  std::optional<LobeSpec> diffuse;
  std::vector<LobeSpec> specular;
};

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
  static Material from_table(std::shared_ptr<const MeasuredTable> table,
                             Interpolation interpolation);

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
