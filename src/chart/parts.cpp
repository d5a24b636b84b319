#include "chart/parts.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/near_names.h"
#include "chart/example.h"

namespace gonio::chart {
namespace {

using Make = std::function<Result<Table>(const Options&)>;

constexpr std::array kParts{Part{"models", false},         Part{"fits", true},
                            Part{"approximations", false}, Part{"directions", false},
                            Part{"sampling", false},       Part{"resolution", true}};

bool is_wanted(const std::vector<std::string>& parts, std::string_view name) {
  return parts.empty() || std::ranges::find(parts, name) != parts.end();
}

// The tables of a part; none where the material lacks what the part needs.
std::vector<Make> tables_of(std::string_view part, const Measured* measured) {
  const auto angles = [](const Options&) -> Result<Table> { return chart_fresnel_angles(); };
  if (part == "models") return {chart_models};
  if (part == "approximations") return {chart_fresnel, angles, chart_printed};
  if (part == "directions") return {chart_directions};
  if (part == "sampling") return {chart_sampling};
  if (part == "fits")
    return {[measured](const Options& options) { return chart_fits(*measured, options); }};
  if (measured->table == nullptr) return {};
  return {[measured](const Options& options) { return chart_resolution(*measured, options); }};
}

Measured example() {
  auto table = example_table(1);
  return {"a generated paint", fit::from_table(*table), table};
}

Outcome check_range(const char* field, double value, double lower, double upper,
                    const char* allowed) {
  if (value >= lower && value <= upper) return Ok{};
  return bad_value(field, std::to_string(value), allowed);
}

}  // namespace

std::span<const Part> all_parts() { return kParts; }

Outcome check(const std::vector<std::string>& parts, const Options& options) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (std::ranges::find(kParts, parts[i], &Part::name) != kParts.end()) continue;
    std::vector<std::string_view> known;
    for (const Part& part : kParts) known.push_back(part.name);
    return unknown_word("parts[" + std::to_string(i) + "]", parts[i], known);
  }
  if (auto good = check_range("repetitions", options.effort.repetitions, 1, 1000, "1 to 1000");
      !good)
    return good;
  if (auto good = check_range("seconds", options.effort.seconds, 1e-6, 0.1, "1e-6 to 0.1"); !good)
    return good;
  return check_range("pairs", static_cast<double>(options.pairs), 1, 20'000, "1 to 20000");
}

bool needs_material(const std::vector<std::string>& parts) {
  return std::ranges::any_of(
      kParts, [&](const Part& part) { return part.of_a_material && is_wanted(parts, part.name); });
}

Result<std::vector<Table>> measure(
    const Wanted& wanted, const Options& options,
    const std::function<void(std::string_view part, double done)>& progress) {
  if (auto good = check(wanted.parts, options); !good) return good.error();
  std::optional<Measured> generated;
  const bool needed = needs_material(wanted.parts);
  if (needed && !wanted.measured) generated = example();
  const Measured* measured = wanted.measured ? &*wanted.measured
                             : generated     ? &*generated
                                             : nullptr;
  const bool by_name = std::ranges::find(wanted.parts, "resolution") != wanted.parts.end();
  if (by_name && measured->table == nullptr) {
    return bad_value("parts", "resolution, of scattered pairs",
                     "resolution of a measured table (MERL) only");
  }
  std::vector<std::string_view> names;
  for (const Part& part : kParts) {
    if (is_wanted(wanted.parts, part.name)) names.push_back(part.name);
  }
  std::vector<Table> tables;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Options of_part = options;
    of_part.progress = [&](double done) {
      if (progress)
        progress(names[i], (static_cast<double>(i) + done) / static_cast<double>(names.size()));
    };
    of_part.progress(0);
    for (const Make& make : tables_of(names[i], measured)) {
      auto table = make(of_part);
      if (!table) return table.error();
      tables.push_back(std::move(*table));
    }
  }
  return tables;
}

std::size_t memory_of(const std::vector<std::string>& parts, const Options& options) {
  constexpr std::size_t kPlain = std::size_t{32} << 20U, kTables = std::size_t{192} << 20U;
  constexpr std::size_t kOfAPair = 6000;  // bytes, at all places: directions, values, truth, errors
  return kPlain + kOfAPair * options.pairs + (needs_material(parts) ? kTables : 0);
}

}  // namespace gonio::chart
