#include "select_materials.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fit/real_data.h"
#include "measured/pairs.h"
#include "measured/solid_angle.h"
#include "select/select.h"

namespace gonio::bench {
namespace {

constexpr std::array kTolerances{0.05, 0.1, 0.2};

struct Measured {
  std::string name;
  std::variant<Material, fit::Data> reference;
};

std::string text(const char* format, double x) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

fit::Data data_of(const Result<MeasuredPairs>& read, const std::filesystem::path& file) {
  if (!read) {
    std::fprintf(stderr, "select_bench: %s: %s\n", file.c_str(), read.error().message.c_str());
    std::exit(1);
  }
  const auto weights = read->weights.empty() ? pair_measures(read->wi, read->wo) : read->weights;
  return *fit::from_pairs(read->wi, read->wo, read->values, read->channels, weights);
}

// Tables of the MERL database, which can be evaluated; and the pairs of other databases, which
// cannot.
std::vector<Measured> measured() {
  std::vector<Measured> all;
  for (const char* name : testing::kFitMaterials) {
    const auto material = testing::NpfMaterial::load(name);
    if (!material) std::fprintf(stderr, "select_bench: no material %s\n", name), std::exit(1);
    auto table = *MeasuredTable::from_values(testing::tabulate(*material));
    all.push_back({name, Material::from_table(std::move(table), Interpolation::linear)});
  }
  const auto folder = testing::data_folder();
  const auto add = [&](const char* place, const char* name, const char* extension, auto read) {
    const auto file = folder / place / (std::string(name) + extension);
    all.push_back({name, data_of(read(file), file)});
  };
  for (const char* name : {"garnet_red", "krylon_blue", "mystique"})
    add("cornell", name, ".brdf", read_cornell);
  for (const char* name : {"retro-3M-jaune", "retro-gray-tape"})
    add("retro", name, ".dat", read_alta);
  for (const char* name :
       {"paper_white_rgb", "satin_rosaline_rgb", "cc_ibiza_sunset_rgb", "cg_sunflower_rgb"})
    add("rgl", name, ".bsdf", read_rgl);
  return all;
}

select::Scene scene_of(select::Range theta_i, select::Range theta_o, double tolerance) {
  constexpr double kRadians = std::numbers::pi / 180;
  const auto radians = [](select::Range r) {
    return select::Range{r.lower * kRadians, r.upper * kRadians};
  };
  select::Scene scene;
  scene.bins = {{radians(theta_i), radians(theta_o)}};
  scene.tolerance = tolerance;
  return scene;
}

// None where the scene holds too little of what was measured.
std::optional<select::Selection> choose(const Measured& of, const select::Scene& scene,
                                        bool whole_front) {
  select::Options options;
  options.whole_front = whole_front;
  auto found =
      std::visit([&](const auto& reference) { return select::choose(reference, scene, options); },
                 of.reference);
  if (found) return std::move(*found);
  std::fprintf(stderr, "%s: %s\n", of.name.c_str(), found.error().message.c_str());
  return std::nullopt;
}

const select::Entry* reference_of(const select::Selection& found) {
  const auto at = std::find_if(found.entries.begin(), found.entries.end(),
                               [](const auto& entry) { return !entry.material; });
  return at == found.entries.end() ? nullptr : &*at;
}

const select::Entry& best_fitting(const select::Selection& found) {
  const select::Entry* best = nullptr;
  for (const select::Entry& entry : found.entries) {
    if (!entry.material) continue;
    if (best == nullptr || entry.error.value < best->error.value) best = &entry;
  }
  return *best;
}

std::string costs(const select::Entry& entry) {
  const auto bytes = static_cast<double>(entry.bytes);
  return text("%.1f ns, ", entry.ns) +
         (bytes < 1e6 ? text("%.1f kB", 1e-3 * bytes) : text("%.1f MB", 1e-6 * bytes));
}

std::string error(const select::Bounded& error) {
  return text("%.2f % % (", 100 * error.value) + text("%.2f", 100 * error.lower) +
         text("-%.2f)", 100 * error.upper);
}

// In a short cell: name, error, costs.
std::string cell(const select::Selection& found) {
  if (!found.choice) return "nothing";
  const select::Entry& entry = found.entries[found.choice->entry];
  if (!entry.material) return "the table itself";
  return entry.name + "<br>" + text("%.1f %%, at most ", 100 * found.choice->error.value) +
         text("%.1f<br>", 100 * found.choice->error.upper) + costs(entry);
}

std::string best_cell(const select::Selection& found) {
  const select::Entry& best = best_fitting(found);
  return best.name + "<br>" + text("%.1f %%<br>", 100 * best.error.value) + costs(best);
}

std::string table_cell(const select::Selection& found) {
  const select::Entry* table = reference_of(found);
  return table == nullptr ? "cannot be evaluated" : costs(*table);
}

// A line with everything.
std::string line(const Measured& of, double tolerance, const select::Selection& found,
                 const select::Selection& front) {
  const select::Entry& best = best_fitting(front);
  std::string row = "| " + of.name + " | " + text("%g %% | ", 100 * tolerance);
  if (found.choice) {
    const select::Entry& entry = found.entries[found.choice->entry];
    row += entry.name + " | " + error(found.choice->error) +
           text(", %.4g %% sure | ", 100 * found.choice->confidence) + costs(entry);
  } else {
    row += "nothing | | ";
  }
  return row + " | " + table_cell(front) + " | " + best.name + " | " + error(best.error) + " | " +
         costs(best) + " |\n";
}

}  // namespace

bool print_choices(std::string_view part) {
  std::string details =
      "| material | tolerance | choice | its error, certified | costs | the measured table | "
      "best-fitting "
      "model | its error | costs |\n|---|---|---|---|---|---|---|---|---|\n";
  std::printf(
      "| material | 5 %% | 10 %% | 20 %% | always the best-fitting model | always the table "
      "|\n|---|---|---|---|---|---|\n");
  for (const Measured& of : measured()) {
    if (of.name.find(part) == std::string::npos) continue;
    std::string row = "| " + of.name;
    std::optional<select::Selection> front;
    for (const double tolerance : kTolerances) {
      const auto found = choose(of, scene_of({0, 75}, {0, 75}, tolerance), !front);
      if (!found) return false;
      if (!front) front = found;
      row += " | " + cell(*found);
      details += line(of, tolerance, *found, *front);
    }
    std::printf("%s | %s | %s |\n", row.c_str(), best_cell(*front).c_str(),
                table_cell(*front).c_str());
    std::fflush(stdout);
  }
  std::printf("\n%s", details.c_str());
  return true;
}

bool print_by_view() {
  std::printf("| material | views up to 20 degrees | views up to 85 degrees |\n|---|---|---|\n");
  std::string reasons;
  for (const Measured& of : measured()) {
    if (!std::holds_alternative<Material>(of.reference)) continue;
    const auto near = choose(of, scene_of({0, 75}, {0, 20}, 0.1), false),
               grazing = choose(of, scene_of({0, 75}, {0, 85}, 0.1), false);
    if (!near || !grazing) return false;
    std::printf("| %s | %s | %s |\n", of.name.c_str(), cell(*near).c_str(), cell(*grazing).c_str());
    std::fflush(stdout);
    reasons +=
        of.name + "\n  near the normal: " + near->reason + "\n  grazing: " + grazing->reason + "\n";
  }
  std::printf("\n%s", reasons.c_str());
  return true;
}

}  // namespace gonio::bench
