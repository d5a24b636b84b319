#include "client/cli/report/markdown.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/join.h"
#include "client/cli/output/numbers.h"
#include "client/cli/report/model_page.h"
#include "client/cli/report/presets.h"

namespace gonio::cli {
namespace {

std::string code(std::string_view name) { return "`" + std::string(name) + "`"; }

std::string codes(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(code(name));
  return joined(quoted, ", ");
}

// Prose in a cell: what Markdown would take for its own is not.
std::string prose(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("|*_<").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

using Row = std::vector<std::string>;

// In plain text too, a table's narrow columns shall stand below each other; wider cells are prose.
constexpr std::size_t kNarrow = 44;

std::string line(const Row& cells, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::string cell = cells[i];
    if (widths[i] <= kNarrow) cell.resize(std::max(widths[i], cell.size()), ' ');
    text += " " + cell + " |";
  }
  return text + "\n";
}

// The first row is the header.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text = line(rows.front(), widths) + "|";
  for (std::size_t i = 0; i < widths.size(); ++i) text += "---|";
  text += "\n";
  for (std::size_t i = 1; i < rows.size(); ++i) text += line(rows[i], widths);
  return text;
}

std::string where(const client::ErrorBound& bound) {
  return "where f > " + shortest(bound.above) + " and both cosines > " + shortest(bound.cosine);
}

// `usual` is what the text above the table says already.
std::string bound_cell(const client::ErrorBound& bound, const std::string& usual) {
  std::string text = shortest(bound.relative);
  if (where(bound) != usual) text += " " + where(bound);
  if (!bound.note.empty()) text += "; " + prose(bound.note);
  return text;
}

std::string models_table(const client::Catalogue& catalogue, const std::string& usual) {
  std::vector<Row> rows{
      {"model", "role", "what it is", "parameters", "fast", "reference", "source"}};
  for (const auto& model : catalogue.models) {
    std::vector<std::string> names;
    for (const auto& parameter : model.parameters) names.push_back(parameter.name);
    std::string summary = prose(model.summary);
    if (model.albedo_limit > 1) summary += "; albedo up to " + shortest(model.albedo_limit);
    rows.push_back({code(model.name), std::string(role_word(model.role)), summary, codes(names),
                    bound_cell(model.fast, usual), bound_cell(model.reference, usual),
                    prose(model.source)});
  }
  return table(rows);
}

std::string values_cell(const client::ParameterInfo& parameter) {
  if (!parameter.words.empty()) return codes(parameter.words);
  if (parameter.file) return "a file's name";
  std::string text = shortest(parameter.lower) + " to " + shortest(parameter.upper);
  if (parameter.unit != "1") text += " " + parameter.unit;
  if (parameter.colour) text += ", a colour";
  if (!parameter.presets.empty()) text += " or a preset";
  return text;
}

Row parameter_cells(const client::ParameterInfo& parameter) {
  std::string meaning = prose(parameter.meaning);
  if (!parameter.used_with.empty()) {
    std::vector<std::string> words;
    for (const auto& word : parameter.used_with_words) words.push_back(code(word));
    meaning += "; with " + code(parameter.used_with) + " " + joined(words, " or ");
  }
  std::string start =
      parameter.words.empty() ? shortest(parameter.start) : code(parameter.words.front());
  if (parameter.file) start = "to be given";
  return {code(parameter.name), values_cell(parameter), start, meaning};
}

// One row for all models in which a parameter is the same.
struct ParameterRow {
  Row cells;  // without the models
  std::vector<std::string> models;
};

void add(std::vector<ParameterRow>& rows, Row cells, const std::string& model) {
  const auto same = std::find_if(rows.begin(), rows.end(),
                                 [&](const ParameterRow& r) { return r.cells == cells; });
  if (same != rows.end()) return same->models.push_back(model);
  // Below others of its name.
  const auto last = std::find_if(rows.rbegin(), rows.rend(), [&](const ParameterRow& r) {
    return r.cells.front() == cells.front();
  });
  rows.insert(last == rows.rend() ? rows.end() : last.base(), {std::move(cells), {model}});
}

std::string parameters_table(const client::Catalogue& catalogue) {
  std::vector<ParameterRow> parameters;
  for (const auto& model : catalogue.models) {
    for (const auto& parameter : model.parameters)
      add(parameters, parameter_cells(parameter), model.name);
  }
  std::vector<Row> rows{{"parameter", "values", "default", "meaning", "models"}};
  for (ParameterRow& parameter : parameters) {
    parameter.cells.push_back(codes(parameter.models));
    rows.push_back(std::move(parameter.cells));
  }
  return table(rows);
}

std::string presets_table(const std::vector<PresetList>& lists) {
  std::vector<Row> rows{{"preset", "of", "red", "green", "blue", "source"}};
  for (const PresetList& list : lists) {
    std::string parameters = codes(list.parameters);
    if (!list.partner.empty()) parameters += ", with " + code(list.partner);
    for (const auto& preset : list.presets) {
      Row cells{code(preset.name), parameters};
      for (const double value : preset.values) cells.push_back(shortest(value));
      cells.push_back(prose(preset.source));
      rows.push_back(std::move(cells));
    }
  }
  return table(rows);
}

}  // namespace

std::string markdown(const client::Catalogue& catalogue) {
  if (catalogue.models.empty()) return {};
  const std::string usual = where(catalogue.models.front().fast);
  std::string text =
      "A diffuse model stands alone or as the base of a sum, a specular one alone or as a lobe of "
      "a sum. Under `fast` and\n`reference` stand the largest relative errors of the two "
      "precisions, " +
      usual + ".\n\n" + models_table(catalogue, usual) +
      "\nBounds include both ends. A colour is one number, or one per channel.\n\n" +
      parameters_table(catalogue);
  const auto lists = preset_lists(catalogue);
  if (lists.empty()) return text;
  return text +
         "\nA preset is a name in the place of the numbers. It has three channels, linear red, "
         "green and blue.\n\n" +
         presets_table(lists);
}

}  // namespace gonio::cli
