#include "client/cli/chart/tables.h"

#include <cmath>

#include "client/cli/output/json.h"
#include "client/cli/output/numbers.h"

namespace gonio::cli {
namespace {

std::string json_cell(const chart::Cell& cell) {
  if (const auto* word = std::get_if<std::string>(&cell)) return json_string(*word);
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? shortest(number) : "null";
}

// A word with a comma or a quote in it is quoted.
std::string csv_cell(const chart::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell))
    return std::isfinite(*number) ? shortest(*number) : "";
  const auto& word = std::get<std::string>(cell);
  if (word.find_first_of(",\"\n") == std::string::npos) return word;
  std::string quoted = "\"";
  for (const char c : word) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

std::string list_of(const std::vector<std::string>& words) {
  std::string text = "[";
  for (const std::string& word : words) text += (text.size() > 1 ? ", " : "") + json_string(word);
  return text + "]";
}

std::string machine_json(const chart::Machine& machine) {
  return "{\"processor\": " + json_string(machine.processor) +
         ", \"cores\": " + std::to_string(machine.cores) +
         ", \"instruction_sets\": " + list_of(machine.instruction_sets) +
         ", \"system\": " + json_string(machine.system) +
         ", \"gonio\": " + json_string(machine.gonio) +
         ", \"compiler\": " + json_string(machine.compiler) + "}";
}

std::string table_json(const chart::Table& table) {
  std::string text = "{\"name\": " + json_string(table.name) +
                     ", \"title\": " + json_string(table.title) + ",\n\"columns\": [";
  const char* separator = "\n";
  for (const chart::Column& column : table.columns) {
    text += separator + ("{\"name\": " + json_string(column.name)) +
            ", \"unit\": " + json_string(column.unit) +
            ", \"meaning\": " + json_string(column.meaning) + "}";
    separator = ",\n";
  }
  text += "],\n\"rows\": [";
  separator = "\n";
  for (const auto& row : table.rows) {
    text += separator;
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i == 0 ? "{" : ", ") + json_string(table.columns[i].name) + ": " + json_cell(row[i]);
    text += "}";
    separator = ",\n";
  }
  return text + "]}";
}

}  // namespace

std::string chart_json(const Chart& chart) {
  std::string text =
      "{\"machine\": " + machine_json(chart.machine) +
      ",\n\"effort\": {\"repetitions\": " + std::to_string(chart.effort.repetitions) +
      ", \"seconds\": " + shortest(chart.effort.seconds) +
      "},\n\"material\": " + json_string(chart.material) + ",\n\"tables\": [";
  const char* separator = "\n";
  for (const chart::Table& table : chart.tables) {
    text += separator + table_json(table);
    separator = ",\n";
  }
  return text + "]}\n";
}

std::string table_csv(const chart::Table& table) {
  std::string text;
  for (const chart::Column& column : table.columns)
    text += (text.empty() ? "" : ",") + csv_cell(column.name);
  text += "\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : ",") + csv_cell(row[i]);
    text += "\n";
  }
  return text;
}

}  // namespace gonio::cli
