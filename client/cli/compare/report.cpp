#include "client/cli/compare/report.h"

#include <cstdio>

#include "client/cli/output/json.h"
#include "client/cli/output/numbers.h"
#include "client/cli/output/text.h"
#include "client/cli/report/fit_table.h"

namespace gonio::cli {
namespace {

std::string region(const char* name, const fit::Region& of) {
  char text[96];
  std::snprintf(text, sizeof(text), "%s %.3g of %.3g", name, of.fitted, of.measured);
  return text;
}

std::string row(const std::string& name, const fit::Comparison& comparison, std::size_t width) {
  const fit::Regions& regions = comparison.regions;
  return padded(name, width) + error_cells(comparison.errors) + "\n    " +
         region("mirror", regions.mirror) + ", " +
         region("toward the light", regions.toward_light) + ", " +
         region("elsewhere", regions.elsewhere) + "\n";
}

std::string json_of(const fit::Errors& errors) {
  if (errors.pairs == 0)
    return R"({"pairs": 0, "l1": null, "rmse": null, "log": null, "cbrt": null})";
  return "{\"pairs\": " + std::to_string(errors.pairs) + ", \"l1\": " + shortest(errors.l1) +
         ", \"rmse\": " + shortest(errors.rmse) + ", \"log\": " + shortest(errors.log) +
         ", \"cbrt\": " + shortest(errors.cbrt) + "}";
}

std::string json_of(const fit::Region& region) {
  return "{\"measured\": " + shortest(region.measured) +
         ", \"fitted\": " + shortest(region.fitted) + ", \"error\": " + shortest(region.error) +
         "}";
}

std::string json_of(const std::string& name, const fit::Comparison& found) {
  return "{\"name\": " + json_string(name) +
         ",\n \"errors\": {\"all\": " + json_of(found.errors.all) +
         ", \"below_80\": " + json_of(found.errors.below_80) +
         ", \"above_80\": " + json_of(found.errors.above_80) +
         "},\n \"regions\": {\"mirror\": " + json_of(found.regions.mirror) +
         ", \"toward_light\": " + json_of(found.regions.toward_light) +
         ", \"elsewhere\": " + json_of(found.regions.elsewhere) + "}}";
}

}  // namespace

std::vector<fit::Comparison> errors_of(const Comparison& comparison) {
  std::vector<fit::Comparison> found;
  for (const Compared& one : comparison.compared)
    found.push_back(fit::compare(one.material, comparison.data, 0));
  return found;
}

std::string compare_table(const Comparison& comparison, const std::vector<fit::Comparison>& found) {
  constexpr std::size_t kName = 28;
  const fit::Data& data = comparison.data;
  std::string text = std::to_string(data.size()) + " pairs, " +
                     std::to_string(data.left_out.total()) + " left out";
  if (comparison.input.raised > 0) text += ", " + raised_text(comparison.input);
  text += "\n\n" + error_head(kName) + "\n";
  for (std::size_t i = 0; i < found.size(); ++i)
    text += row(comparison.compared[i].name, found[i], kName);
  return text;
}

std::string compare_json(const std::string& reference, const Comparison& comparison,
                         const std::vector<fit::Comparison>& found) {
  const fit::Data& data = comparison.data;
  std::string json =
      "{\"reference\": " + json_string(reference) + ", \"pairs\": " + std::to_string(data.size()) +
      ", \"left_out\": " + std::to_string(data.left_out.total()) + ",\n\"materials\": [";
  for (std::size_t i = 0; i < found.size(); ++i)
    json += (i == 0 ? "\n" : ",\n") + json_of(comparison.compared[i].name, found[i]);
  return json + "\n]}\n";
}

}  // namespace gonio::cli
