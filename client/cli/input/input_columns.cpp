#include "client/cli/input/input_columns.h"

#include "client/cli/output/numbers.h"

namespace gonio::cli {
namespace {

template <class T>
char* put_field(char* out, T value) {
  out = put_shortest(out, value);
  *out++ = ',';
  return out;
}

template <class T>
char* put_directions(char* out, const Rows<T>& rows, std::size_t i) {
  for (std::size_t c = 0; c < 3; ++c) out = put_field(out, rows.wi[3 * i + c]);
  for (std::size_t c = 0; c < 3; ++c) out = put_field(out, rows.wo[3 * i + c]);
  return out;
}

}  // namespace

template <class T>
InputColumns<T> grid_columns(const GridSpec& spec) {
  return {spec.names, [&spec](char* out, const Rows<T>& rows, std::size_t i) {
            std::uint64_t inner = *spec.grid.size();
            std::uint64_t rest = rows.first + i;
            for (const std::vector<double>& axis : spec.given) {
              inner /= axis.size();
              out = put_field(out, axis[rest / inner]);
              rest %= inner;
            }
            return out;
          }};
}

template <class T>
InputColumns<T> pair_columns(PairInput<T>& input) {
  return {input.columns(), [&input](char* out, const Rows<T>& rows, std::size_t i) {
            const auto angles = input.take_angles();
            if (!angles) return put_directions(out, rows, i);
            for (const double angle : *angles) out = put_field(out, angle);
            return out;
          }};
}

template InputColumns<float> grid_columns(const GridSpec&);
template InputColumns<double> grid_columns(const GridSpec&);
template InputColumns<float> pair_columns(PairInput<float>&);
template InputColumns<double> pair_columns(PairInput<double>&);

}  // namespace gonio::cli
