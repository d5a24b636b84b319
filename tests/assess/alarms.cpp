#include "assess/alarms.h"

#include <algorithm>

#include "assess/energy.h"
#include "assess/samples.h"
#include "assess/verdict.h"
#include "fit/real_data.h"
#include "gonio/engine/registry.h"

namespace gonio::testing {
namespace {

// Of the checks that samples decide, whatever the table's cells or the energy are found to be.
void count_failures(const assess::Report& report, Alarms& alarms) {
  bool failed = false;
  for (const assess::Check& check : report.checks) {
    const bool of_samples = check.name == "pdf_mass" || check.name == "weights" ||
                            check.name == "sampled_albedo" || check.name == "distribution";
    if (check.name == "sampled_albedo")
      alarms.largest_deviation = std::max(alarms.largest_deviation, check.value);
    if (check.name == "distribution")
      alarms.least_probability = std::min(alarms.least_probability, check.value);
    if (check.passed || !of_samples) continue;
    failed = true;
    alarms.distribution += check.name == "distribution" ? 1 : 0;
    alarms.sampled_albedo += check.name == "sampled_albedo" ? 1 : 0;
    alarms.others += check.name == "pdf_mass" || check.name == "weights" ? 1 : 0;
  }
  alarms.failed += failed ? 1 : 0;
}

}  // namespace

std::vector<GoodMaterial> good_models() {
  std::vector<GoodMaterial> all;
  for (const ModelDescription& model : models()) {
    if (model.role == Role::measured) continue;
    const std::string name(model.name);
    all.push_back({name, [name] {
                     return *Material::create(MaterialSpec{LobeSpec{name, {}}, {}, {}});
                   }});
  }
  return all;
}

std::vector<GoodMaterial> good_tables() {
  std::vector<GoodMaterial> all;
  for (const char* name : kFitMaterials) {
    if (!NpfMaterial::load(name)) continue;
    all.push_back({name, [name] {
                     auto table = *MeasuredTable::from_values(tabulate(*NpfMaterial::load(name)));
                     return Material::from_table(std::move(table), Interpolation::linear);
                   }});
  }
  return all;
}

Alarms alarms_of(const Material& material, std::uint64_t seeds) {
  const assess::Subject subject = assess::subject_of(Sampler::create(material), best_isa());
  std::vector<assess::Energy> energies;
  for (const assess::Angles& angles : assess::incidences_of(subject, 1))
    energies.push_back(assess::integrate_from(angles, subject, {}));
  Alarms alarms;
  assess::Report report;
  report.channels = subject.channels;
  report.fast = stated(subject.fast), report.reference = stated(subject.reference);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    report.incidences.clear();
    for (const assess::Energy& energy : energies)
      report.incidences.push_back(assess::sample_from(energy, subject, seed));
    assess::set_verdict({}, report);
    count_failures(report, alarms);
  }
  return alarms;
}

}  // namespace gonio::testing
