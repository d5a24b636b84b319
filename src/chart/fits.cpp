// Representations of a measured material: fitted models, and the table itself.
#include <algorithm>
#include <array>

#include "chart/chart.h"
#include "chart/common.h"
#include "fit/fit.h"
#include "fit/report/metrics.h"
#include "timing/pairs.h"

namespace gonio::chart {
namespace {

constexpr std::size_t kPairs = 65536;

struct Form {
  const char* name;
  const char* model;
  const char* fresnel;  // or null: the model's default
  int lobes = 1;        // 0: the model alone; else so many lobes over a Lambertian base
};
constexpr std::array kForms{Form{"lambertian", "lambertian", nullptr, 0},
                            Form{"oren_nayar", "oren_nayar", nullptr, 0},
                            Form{"phong", "phong", "schlick"},
                            Form{"blinn_phong", "blinn_phong", "schlick"},
                            Form{"phong_mix", "phong_mix", "schlick"},
                            Form{"ashikhmin_shirley", "ashikhmin_shirley", nullptr},
                            Form{"ward", "ward", nullptr},
                            Form{"cook_torrance schlick", "cook_torrance", "schlick"},
                            Form{"cook_torrance dielectric", "cook_torrance", "dielectric"},
                            Form{"ggx schlick", "ggx", "schlick"},
                            Form{"ggx dielectric", "ggx", "dielectric"},
                            Form{"2 x ggx schlick", "ggx", "schlick", 2}};

MaterialSpec spec_of(const Form& form) {
  MaterialSpec spec;
  LobeSpec lobe{form.model, {}};
  if (form.fresnel != nullptr) lobe.parameters["fresnel"] = std::string(form.fresnel);
  if (form.lobes == 0) {
    spec.model = std::move(lobe);
    return spec;
  }
  spec.diffuse = LobeSpec{"lambertian", {}};
  spec.specular.assign(static_cast<std::size_t>(form.lobes), lobe);
  return spec;
}

std::size_t numbers_of(const LobeSpec& lobe) {
  std::size_t numbers = 0;
  for (const auto& [name, value] : lobe.parameters) {
    if (const auto* all = std::get_if<std::vector<double>>(&value)) numbers += all->size();
  }
  return numbers;
}

// The count of float64 numbers that describe a material.
std::size_t numbers_of(const MaterialSpec& spec) {
  std::size_t numbers = spec.model ? numbers_of(*spec.model) : 0;
  numbers += spec.diffuse ? numbers_of(*spec.diffuse) : 0;
  for (const LobeSpec& lobe : spec.specular) numbers += numbers_of(lobe);
  return numbers;
}

struct Candidate {
  std::string name, verdict;
  Material material;
  double bytes, fit_seconds;
  fit::ErrorsByZone errors;
};

Result<std::vector<Candidate>> candidates_of(const Measured& measured, const Options& options) {
  std::vector<Candidate> all;
  for (const Form& form : kForms) {
    auto fitted =
        fit::fit(measured.data, spec_of(form), {}, {.progress = {}, .stop = options.stop});
    if (!fitted) return fitted.error();
    const fit::Certificate& certificate = fitted->certificate;
    if (certificate.verdict == fit::Verdict::failed) continue;
    all.push_back({form.name, std::string(name_of(certificate.verdict)),
                   *Material::create(fitted->material),
                   static_cast<double>(numbers_of(fitted->material) * sizeof(double)),
                   certificate.cpu_seconds, certificate.errors});
    show(options, static_cast<double>(all.size()) / (kForms.size() + 2));
  }
  if (all.empty()) {
    return bad_value("data",
                     std::to_string(measured.data.size()) + " usable pairs (" +
                         std::to_string(measured.data.left_out.total()) + " left out)",
                     "pairs that a model can be fitted to");
  }
  if (measured.table == nullptr) return all;
  for (const auto& [name, interpolation] :
       {std::pair{"table, nearest cell", Interpolation::nearest},
        std::pair{"table, interpolated", Interpolation::linear}}) {
    const Material table = Material::from_table(measured.table, interpolation);
    all.push_back({name, "measured", table, static_cast<double>(table.bytes()), 0,
                   fit::compare(table, measured.data, 0).errors});
  }
  return all;
}

struct Metric {
  const char* name;
  double fit::Errors::*value;
  const char* unit;
  const char* meaning;
};
constexpr std::array kMetrics{
    Metric{"l1", &fit::Errors::l1, "1", "relative, weighed by the cosine of incidence"},
    Metric{"rmse", &fit::Errors::rmse, "1/sr", "root mean square"},
    Metric{"log", &fit::Errors::log, "1", "mean of logarithms"},
    Metric{"cbrt", &fit::Errors::cbrt, "1", "root mean square of cube roots"}};
struct Zone {
  const char* name;
  fit::Errors fit::ErrorsByZone::*errors;
  const char* meaning;
};
constexpr std::array kZones{
    Zone{"all", &fit::ErrorsByZone::all, "all angles"},
    Zone{"below_80", &fit::ErrorsByZone::below_80, "both angles up to 80 degrees"},
    Zone{"above_80", &fit::ErrorsByZone::above_80, "beyond"}};

Table empty_table(const std::string& name) {
  Table table{"fits",
              "What represents " + name + ": ns per evaluation and bytes against error",
              {{"representation", "", "a fitted model over a Lambertian base, or the table"},
               {"verdict", "", "of the fit"}},
              {}};
  add_time_columns(table, "ns", "ns", "time of one evaluation, fast, the best instruction set");
  table.columns.push_back({"bytes", "B", "of the numbers that write it down"});
  table.columns.push_back({"fit_seconds", "s", "processor time of the fit"});
  for (const Metric& metric : kMetrics) {
    for (const Zone& zone : kZones) {
      table.columns.push_back({std::string(metric.name) + "_" + zone.name, metric.unit,
                               std::string(metric.meaning) + "; " + zone.meaning});
    }
  }
  return table;
}

}  // namespace

Result<Table> chart_fits(const Measured& measured, const Options& options) {
  const auto candidates = candidates_of(measured, options);
  if (!candidates) return candidates.error();
  // So many pairs that the nearest caches do not hold the cells of a table.
  const auto pairs = std::make_shared<timing::Pairs>(kPairs, std::max(3, measured.data.channels));
  std::vector<timing::Runner> runners;
  for (const Candidate& candidate : *candidates)
    runners.push_back(timing::evaluation(pairs, candidate.material, Precision::fast, best_isa()));
  const auto seconds = timing::race(runners, options.effort, options.stop);
  if (is_over(options)) return was_cancelled();
  Table table = empty_table(measured.name);
  for (std::size_t i = 0; i < candidates->size(); ++i) {
    const Candidate& candidate = (*candidates)[i];
    std::vector<Cell> row{candidate.name, candidate.verdict};
    add_time_cells(row, scaled(seconds[i], 1e9));
    row.emplace_back(candidate.bytes);
    row.emplace_back(candidate.fit_seconds);
    for (const Metric& metric : kMetrics) {
      for (const Zone& zone : kZones) row.emplace_back(candidate.errors.*zone.errors.*metric.value);
    }
    table.rows.push_back(std::move(row));
  }
  add_front(table, "ns", "l1_all", "");
  show(options, 1);
  return table;
}

}  // namespace gonio::chart
