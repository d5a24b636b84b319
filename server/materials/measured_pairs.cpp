#include "server/materials/measured_pairs.h"

#include <string>
#include <vector>

#include "base/near_names.h"
#include "engine/material/material_impl.h"
#include "wire/message.h"

namespace gonio::server {
namespace {

template <class From>
std::vector<double> wide(const From& numbers) {
  return {numbers.begin(), numbers.end()};
}

Error within_pairs(Error error) {
  error.field = "pairs." + error.field;
  error.message = "pairs." + error.message;
  return error;
}

Error not_measured(const std::string& found) {
  return bad_value("measured", found,
                   R"(a measured material that the server holds, such as {"name": "nickel"})");
}

}  // namespace

Outcome check_pairs(const v1::MeasuredPairs& pairs) {
  const auto channels = static_cast<std::size_t>(pairs.channels());
  if (channels >= 1 && channels <= static_cast<std::size_t>(kMaxChannels)) return Ok{};
  return bad_value("pairs.channels", std::to_string(channels),
                   "1 to " + std::to_string(kMaxChannels));
}

std::size_t bytes_of_pair(std::size_t channels) {
  constexpr std::size_t kDirections = 6 * (4 + 8 + 4) + 16;
  return kDirections + 16 * channels;
}

Result<fit::Data> data_of(const v1::MeasuredPairs& pairs) {
  auto data = fit::from_pairs(wide(pairs.wi()), wide(pairs.wo()), wide(pairs.values()),
                              static_cast<int>(pairs.channels()), wide(pairs.weights()));
  if (!data) return within_pairs(data.error());
  return data;
}

Result<std::shared_ptr<const MeasuredTable>> table_of(const v1::Material& measured,
                                                      const Materials& materials) {
  auto material = materials.resolve(wire::to_bytes(measured));
  if (!material) {
    Error error = material.error();
    if (error.field.rfind("material.", 0) != 0) return error;
    error.field.replace(0, 8, "measured");
    if (error.message.rfind("material.", 0) == 0) error.message.replace(0, 8, "measured");
    return error;
  }
  auto table = table_of(material->material());
  if (table) return table;
  const std::string& name = measured.name();
  if (name.empty() || materials.holds(name)) return not_measured("an analytic material");
  // A substance's name stands for no measurements.
  return bad_value(
      "measured.name", '"' + name + '"',
      "a measured material that the server holds, such as: " + near_names(name, materials.names()),
      ErrorCode::not_found);
}

}  // namespace gonio::server
