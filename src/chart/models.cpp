// Models x precision x instruction set: time against error.
#include <optional>

#include "assess/accuracy.h"
#include "assess/places.h"
#include "chart/cases.h"
#include "chart/chart.h"
#include "chart/common.h"

namespace gonio::chart {
namespace {

// One way to evaluate one material.
struct Choice {
  std::string model, precision, isa;
  timing::Runner runner;
  ErrorStatistics errors;
};

// A hand-written loop would normalise its directions before.
bool is_fair(std::size_t place) { return assess::places()[place].name != "off_unit"; }

assess::PlaceErrors errors_of(const Material& material, Isa isa, const Options& options) {
  const assess::Subject subject = assess::subject_of(Sampler::create(material), isa);
  assess::PlaceErrors errors;
  for (std::size_t place = 0; place < assess::places().size(); ++place) {
    if (is_fair(place) && !is_over(options))
      assess::add_errors_at(place, subject, options.pairs, options.seed, errors);
  }
  return errors;
}

using PairsOfOneTile = std::shared_ptr<timing::Pairs>;

void add_choices(const ModelCase<float>& model, PrintedForm<double> printed64,
                 const PairsOfOneTile& pairs, const Options& options,
                 std::vector<Choice>& choices) {
  const Material material = *Material::create(model.spec);
  std::optional<assess::PlaceErrors> errors;
  for (const Isa isa : supported_isas()) {
    errors = errors_of(material, isa, options);
    const std::string name(name_of(isa));
    choices.push_back({model.name, "fast", name,
                       timing::evaluation(pairs, material, Precision::fast, isa),
                       statistics_of(std::move(errors->fast))});
    choices.push_back({model.name, "reference", name,
                       timing::evaluation(pairs, material, Precision::reference, isa),
                       statistics_of(std::move(errors->reference))});
  }
  choices.push_back({model.name, "float", "scalar", printed_evaluation<float>(pairs, model.printed),
                     statistics_of(std::move(errors->naive32))});
  choices.push_back({model.name, "double", "scalar", printed_evaluation<double>(pairs, printed64),
                     statistics_of(std::move(errors->naive64))});
}

Table empty_table() {
  Table table{
      "models",
      "Models by precision and instruction set: ns per evaluation against relative error",
      {{"model", "", "a material of this model"},
       {"precision", "",
        "fast and reference: gonio's; float and double: the formula as printed, in that type"},
       {"instruction_set", "", "scalar: a loop over one pair at a time"}},
      {}};
  add_time_columns(table, "ns", "ns", "time of one evaluation of three channels");
  add_error_columns(table);
  return table;
}

}  // namespace

Result<Table> chart_models(const Options& options) {
  const auto pairs = std::make_shared<timing::Pairs>(timing::kTimedPairs);
  const auto floats = model_cases<float>();
  const auto doubles = model_cases<double>();
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < floats.size(); ++i) {
    add_choices(floats[i], doubles[i].printed, pairs, options, choices);
    if (is_over(options)) return was_cancelled();
    show(options, 0.5 * static_cast<double>(i + 1) / static_cast<double>(floats.size()));
  }
  std::vector<timing::Runner> runners;
  for (const Choice& choice : choices) runners.push_back(choice.runner);
  const auto seconds = timing::race(runners, options.effort, options.stop);
  if (is_over(options)) return was_cancelled();
  Table table = empty_table();
  for (std::size_t i = 0; i < choices.size(); ++i) {
    std::vector<Cell> row{choices[i].model, choices[i].precision, choices[i].isa};
    add_time_cells(row, scaled(seconds[i], 1e9));
    add_error_cells(row, choices[i].errors);
    table.rows.push_back(std::move(row));
  }
  add_front(table, "ns", "error_worst", "model");
  show(options, 1);
  return table;
}

}  // namespace gonio::chart
