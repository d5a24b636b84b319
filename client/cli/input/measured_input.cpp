#include "client/cli/input/measured_input.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "client/cli/arguments/material_argument.h"
#include "client/cli/input/degrees_hint.h"
#include "client/cli/input/file_kind.h"
#include "client/cli/input/npy_header.h"
#include "fit/data/data.h"
#include "gonio/measured/table.h"
#include "measured/pairs.h"
#include "measured/solid_angle.h"

namespace gonio::cli {
namespace {

std::vector<float> narrow(const std::vector<double>& numbers) {
  std::vector<float> to;
  to.reserve(numbers.size());
  for (const double x : numbers) to.push_back(static_cast<float>(x));
  return to;
}

std::vector<double> wide(const std::vector<float>& numbers) {
  return {numbers.begin(), numbers.end()};
}

// Without weights of its own, a goniometer's data get those of the directions that they stand for.
Result<MeasuredInput> weighed(Result<MeasuredInput> input) {
  if (input && input->weights.empty())
    input->weights = narrow(pair_measures(wide(input->wi), wide(input->wo)));
  return input;
}

Result<MeasuredInput> from_pairs(const Result<MeasuredPairs>& pairs) {
  if (!pairs) return pairs.error();
  MeasuredInput input;
  input.channels = pairs->channels;
  input.wi = narrow(pairs->wi);
  input.wo = narrow(pairs->wo);
  input.values = narrow(pairs->values);
  input.weights = narrow(pairs->weights);
  input.raised = pairs->raised;
  return input;
}

// The cells that hold a measurement.
Result<MeasuredInput> from_merl(const std::string& file) {
  auto table = MeasuredTable::read_merl(file);
  if (!table) return table.error();
  const fit::Data data = fit::from_table(**table);
  const auto channels = static_cast<std::size_t>(data.channels);
  MeasuredInput input;
  input.channels = data.channels;
  input.weights = data.weights;
  input.wi.reserve(3 * data.size());
  input.wo.reserve(3 * data.size());
  input.values.reserve(channels * data.size());
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      input.wi.push_back(data.wi[k][i]);
      input.wo.push_back(data.wo[k][i]);
    }
    for (std::size_t c = 0; c < channels; ++c)
      input.values.push_back(data.values[c * data.size() + i]);
  }
  return input;
}

// The format: by the content where that says it, else by the extension.
FileKind format_of(const std::string& file) {
  const FileKind kind = kind_of_file(file).value_or(FileKind::unknown);
  const std::string extension = extension_of(file);
  if (kind != FileKind::unknown) return kind;
  if (extension == ".binary") return FileKind::merl;
  if (extension == ".brdf") return FileKind::cornell;
  if (extension == ".dat" || extension == ".alta") return FileKind::alta;
  return extension == ".bsdf" ? FileKind::rgl : FileKind::csv_values;
}

Result<MeasuredInput> read_table(const std::string& file, bool degrees) {
  auto source = ByteSource::open(file);
  if (!source) return std::move(source).error();
  auto start = source->peek(kNpyMagic.size());
  if (!start) return start.error();
  if (*start == kNpyMagic) return weighed(read_measured_npy(std::move(*source)));
  auto input = read_measured_csv(std::move(*source), degrees);
  if (input && !degrees && kind_of_file(file) == FileKind::csv_values)
    hint_at_degrees(input->wi, input->wo, file);
  return weighed(std::move(input));
}

Result<MeasuredInput> read_any(const std::string& file, bool keep_tables, bool degrees) {
  switch (const FileKind format = format_of(file)) {
    case FileKind::merl: {
      if (!keep_tables) return from_merl(file);
      auto material = read_material(file, true);
      if (!material) return material.error();
      MeasuredInput input;
      input.measured = std::move(*material);
      return input;
    }
    case FileKind::cornell:
      return weighed(from_pairs(read_cornell(file)));
    case FileKind::alta:
      return weighed(from_pairs(read_alta(file)));
    case FileKind::rgl:
      return from_pairs(read_rgl(file));
    case FileKind::npy:
    case FileKind::csv_values:
    case FileKind::csv_pairs:
    case FileKind::unknown:
      return read_table(file, degrees);
    default:
      return wrong_kind("--data", file, format, "measured reflectance");
  }
}

}  // namespace

std::string raised_text(const MeasuredInput& input) {
  if (input.raised == 0) return {};
  return std::to_string(input.raised) + (input.raised == 1 ? " value" : " values") +
         " below 0 set to 0 (colours that sRGB cannot show)";
}

Result<MeasuredInput> read_measured(const std::string& file, bool keep_tables, bool degrees) {
  auto input = read_any(file, keep_tables, degrees);
  if (!input) return or_near_file(input.error(), file);
  return input;
}

Result<MeasuredInput> read_data(const std::string& data, bool embedded, bool degrees) {
  const std::filesystem::path path = data;
  std::error_code ignored;
  const bool name = !path.has_parent_path() && !path.has_extension() && data != "-" &&
                    !std::filesystem::exists(path, ignored);
  if (embedded || !name) return read_measured(data, embedded, degrees);
  MeasuredInput input;
  input.measured = client::Material::named(data);
  return input;
}

}  // namespace gonio::cli
