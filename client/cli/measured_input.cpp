#include "client/cli/measured_input.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "client/cli/material_argument.h"
#include "client/cli/npy_header.h"
#include "fit/data.h"
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

}  // namespace

std::string raised_text(const MeasuredInput& input) {
  if (input.raised == 0) return {};
  return std::to_string(input.raised) + (input.raised == 1 ? " value" : " values") +
         " below 0 set to 0 (colours that sRGB cannot show)";
}

Result<MeasuredInput> read_measured(const std::string& file, bool keep_tables, bool degrees) {
  const std::string extension = std::filesystem::path(file).extension();
  if (extension == ".binary" && keep_tables) {
    auto material = read_material(file, true);
    if (!material) return material.error();
    MeasuredInput input;
    input.measured = std::move(*material);
    return input;
  }
  if (extension == ".binary") return from_merl(file);
  if (extension == ".brdf") return weighed(from_pairs(read_cornell(file)));
  if (extension == ".dat" || extension == ".alta") return weighed(from_pairs(read_alta(file)));
  if (extension == ".bsdf") return from_pairs(read_rgl(file));
  auto source = ByteSource::open(file);
  if (!source) return std::move(source).error();
  auto start = source->peek(kNpyMagic.size());
  if (!start) return start.error();
  if (*start == kNpyMagic) return weighed(read_measured_npy(std::move(*source)));
  return weighed(read_measured_csv(std::move(*source), degrees));
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
