#include "client/cli/arguments/wi_argument.h"

#include <algorithm>
#include <utility>

#include "client/cli/output/numbers.h"
#include "gonio/client/types.h"
#include "kernels/direction_flags.h"
#include "server/arguments/options.h"

namespace gonio::cli {

const char* const kWiHelp = R"(
Directions wi to the light: --wi X,Y,Z, of length 1 within 0.001 and above the horizon; or a file, CSV
with the header wi_x,wi_y,wi_z or theta_i,phi_i (angles in radians, or degrees with --deg), or NPY,
float32 or float64, N x 3. Those of a file that cannot be are flagged.
)";

void add_wi_options(CLI::App& command, WiArguments& arguments) {
  const arguments::Option one =
      arguments::add_option(command, "--wi", arguments.wi, "The direction to the light")
          .type_name("X,Y,Z");
  arguments::add_option(command, "--wi-file", arguments.wi_file,
                        "In place of --wi: directions from a file (see below); - is stdin")
      .type_name("FILE")
      .excludes(one);
  arguments::add_flag(command, "--deg", arguments.degrees, "Angles are in degrees");
}

Result<std::array<double, 3>> parse_wi(const std::string& text) {
  constexpr const char* kAllowed = "X,Y,Z of length 1 with Z above 0";
  std::array<double, 3> wi{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < wi.size(); ++i) {
    const bool is_last = i + 1 == wi.size();
    const std::size_t comma = is_last ? rest.size() : rest.find(',');
    const auto number = parse_number<double>(rest.substr(0, comma));
    if (!number || comma == std::string_view::npos) {
      return bad_value("--wi", "'" + text + "'", kAllowed);
    }
    wi[i] = *number;
    rest.remove_prefix(is_last ? comma : comma + 1);
  }
  const std::uint8_t flags =
      direction_flags(wi[0], wi[1], wi[2], client::flag::incident_below_horizon);
  for (std::size_t bit = 0; bit < client::kFlagBits; ++bit) {
    if (((flags >> bit) & 1U) == 0) continue;
    return bad_value("--wi", text + " (" + std::string(client::flag_meaning(bit)) + ")", kAllowed);
  }
  return wi;
}

template <class T>
Result<WiInput<T>> WiInput<T>::open(const WiArguments& arguments) {
  WiInput input;
  if (!arguments.wi.empty()) {
    auto wi = parse_wi(arguments.wi);
    if (!wi) return wi.error();
    input.single_ = *wi;
    return input;
  }
  if (arguments.wi_file.empty()) {
    return bad_value("the input", "missing", "--wi X,Y,Z or --wi-file FILE");
  }
  auto file = open_pairs<T>(InputKind::wi, arguments.wi_file, arguments.degrees, false);
  if (!file) return file.error();
  input.file_ = std::move(file).value();
  return input;
}

template <class T>
Result<std::size_t> WiInput<T>::read(std::span<T> wi) {
  if (file_) return file_->read(wi, {});
  if (!single_) return std::size_t{0};
  std::transform(single_->begin(), single_->end(), wi.begin(),
                 [](double x) { return static_cast<T>(x); });
  single_.reset();
  return std::size_t{1};
}

template <class T>
std::optional<std::uint64_t> WiInput<T>::total() const {
  return file_ ? file_->total() : std::optional<std::uint64_t>(1);
}

template <class T>
std::optional<double> WiInput<T>::progress() const {
  return file_ ? file_->progress() : std::nullopt;
}

template class WiInput<float>;
template class WiInput<double>;

}  // namespace gonio::cli
