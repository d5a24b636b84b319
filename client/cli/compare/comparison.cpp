#include "client/cli/compare/comparison.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "base/text/join.h"
#include "client/cli/arguments/material_argument.h"
#include "client/cli/output/terminal.h"
#include "client/cli/report/fit_table.h"
#include "engine/material/material_impl.h"
#include "server/materials/materials.h"

namespace gonio::cli {
namespace {

Result<Compared> build(const server::Materials& materials, const std::string& argument) {
  auto material = read_material(argument, true);
  if (!material) return material.error();
  auto built = materials.resolve(material->wire());
  if (!built) return built.error();
  return Compared{shown_name(argument), std::move(*material), built->material()};
}

// A file's measurements, and what the core has of them.
struct Reference {
  MeasuredInput input;
  fit::Data data;
  std::shared_ptr<const MeasuredTable> table;  // null: pairs
};

Result<fit::Data> data_of(const MeasuredInput& input, const MeasuredTable* table) {
  if (table != nullptr) return fit::from_table(*table);
  const auto wide = [](const std::vector<float>& x) {
    return std::vector<double>(x.begin(), x.end());
  };
  return fit::from_pairs(wide(input.wi), wide(input.wo), wide(input.values), input.channels,
                         wide(input.weights));
}

// Nothing can be said of measurements of which none can be used.
Outcome check_usable(const std::string& file, const fit::Data& data) {
  if (data.size() > 0) return Ok{};
  const std::vector<std::string> why = left_out_words(data.left_out);
  const std::string reasons = why.empty() ? "" : " (" + joined(why, ", ") + ")";
  return bad_value(
      "the data of " + file,
      "without a usable pair, " + std::to_string(data.left_out.total()) + " left out" + reasons,
      "one pair or more whose directions and values can be used");
}

Outcome check_channels(const std::string& name, const Material& material, const fit::Data& data) {
  if (material.channels() == 1 || material.channels() == data.channels) return Ok{};
  return bad_value("--material " + name,
                   "a material of " + std::to_string(material.channels()) + " channels",
                   (data.channels == 1 ? "1" : "1 or " + std::to_string(data.channels)) +
                       ", those of the reference");
}

Result<Reference> read_reference(const std::string& file, bool degrees,
                                 const server::Materials& materials) {
  auto input = read_measured(file, true, degrees);
  if (!input) return input.error();
  std::shared_ptr<const MeasuredTable> table;
  if (input->measured) {
    const auto material = materials.resolve(input->measured->wire());
    if (!material) return material.error();
    table = table_of(material->material());
  }
  auto data = data_of(*input, table.get());
  if (!data) return data.error();
  if (auto usable = check_usable(file, *data); !usable) return usable.error();
  return Reference{std::move(*input), std::move(*data), std::move(table)};
}

}  // namespace

std::string shown_name(const std::string& argument) {
  if (argument.find('{') != std::string::npos) return argument;
  return std::filesystem::path(argument).filename().string();
}

Result<Comparison> read_comparison(const std::string& reference,
                                   const std::vector<std::string>& arguments, bool degrees) {
  server::Materials materials;
  materials.allow_local_files();
  auto read = read_reference(reference, degrees, materials);
  if (!read) return read.error();
  Comparison comparison{std::move(read->input), std::move(read->data), {}};
  for (const std::string& argument : arguments) {
    auto one = build(materials, argument);
    if (!one) return one.error();
    if (auto agree = check_channels(argument, one->material, comparison.data); !agree)
      return agree.error();
    comparison.compared.push_back(std::move(*one));
  }
  return comparison;
}

Result<chart::Measured> read_chart_data(const std::string& file, bool degrees) {
  server::Materials materials;
  materials.allow_local_files();
  auto read = read_reference(file, degrees, materials);
  if (!read) return read.error();
  if (read->input.raised > 0) print_note(file + ": " + raised_text(read->input));
  return chart::Measured{shown_name(file), std::move(read->data), std::move(read->table)};
}

}  // namespace gonio::cli
