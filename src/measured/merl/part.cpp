#include "measured/merl/part.h"

#include <algorithm>
#include <array>
#include <utility>

#include "measured/merl/constants.h"
#include "measured/merl/sampling.h"
#include "measured/merl/truth.h"

namespace gonio {

using MerlKernels = KernelArray<2>;
namespace baseline {
extern const MerlKernels kMerlKernels;
}
namespace avx2 {
extern const MerlKernels kMerlKernels;
}
namespace avx512 {
extern const MerlKernels kMerlKernels;
}

namespace merl {
namespace {

constexpr std::array<std::string_view, 2> kInterpolations{"linear", "nearest"};
constexpr std::array kParameters{
    Parameter{
        .name = "file", .meaning = "a MERL .binary file", .unit = "1", .type = ParameterType::file},
    Parameter{.name = "interpolation",
              .meaning = "between the centres of the neighbouring valid cells, or the cell that "
                         "holds the directions",
              .unit = "1",
              .type = ParameterType::word,
              .words = kInterpolations}};
constexpr ModelDescription kDescription{
    .name = "measured",
    .summary =
        "a table of measurements (MERL .binary), stored with the server or read from a local file",
    .source =
        "Matusik, Pfister, Brand & McMillan 2003, A Data-Driven Reflectance Model; Rusinkiewicz "
        "1998",
    .role = Role::measured,
    .parameters = kParameters,
    .fast = {.relative = 1e-5,
             .note = "of the largest of the table's cells that are interpolated; nearest: away "
                     "from cell boundaries"},
    .reference = {.relative = 1e-10,
                  .note = "of the largest of the table's cells that are interpolated; nearest: "
                          "away from cell boundaries"},
    .albedo_limit = 0};

// The data of a part: it keeps the table that the kernels' constants point to.
struct Owner {
  Constants constants;
  std::shared_ptr<const MeasuredTable> table;
};

const Owner& owner_of(const Part& part) { return *static_cast<const Owner*>(part.made.data.get()); }

std::shared_ptr<const MeasuredTable> table_of(const Part& part) { return owner_of(part).table; }

template <int kCorners>
void add_truth(const void* data, const Geometry<Extended>& pair, std::span<long double> f,
               std::span<long double> scale) {
  add_cells<kCorners>(static_cast<const Owner*>(data)->constants.table, pair, f, scale);
}

template <int kCorners>
PartTruth truth_of(const Part& part) {
  return {part.made.data, &add_truth<kCorners>};
}

// What draws read, with what it points to.
struct DrawnOwner {
  Drawn drawn;
  TableSampling sampling;
  std::shared_ptr<const void> data;

  DrawnOwner(const Part& part, const PartLuminance& luminance)
      : drawn{owner_of(part).constants, &sampling}, sampling(luminance), data(part.made.data) {}
};

PartData prepare_sampling(const Part& part, const PartLuminance& luminance) {
  auto owner = std::make_shared<const DrawnOwner>(part, luminance);
  const std::size_t bytes = owner->sampling.bytes();
  return {std::move(owner), bytes};
}

template <int kCorners>
constexpr PartKind kind(std::size_t i) {
  return {.by_isa = {baseline::kMerlKernels.of + i, avx2::kMerlKernels.of + i,
                     avx512::kMerlKernels.of + i},
          .truth = &truth_of<kCorners>,
          .prepare_sampling = &prepare_sampling,
          .has_gaps = true,
          .table = &table_of};
}

// In the order of kInterpolations.
constexpr std::array kKinds{kind<8>(0), kind<1>(1)};

Result<Part> read(const std::filesystem::path& file, const CheckedLobe& lobe) {
  auto table = MeasuredTable::read_merl(file);
  if (!table) return table.error();
  return merl_part(std::move(*table),
                   lobe.kind == 0 ? Interpolation::linear : Interpolation::nearest);
}

}  // namespace

void draw(const TableSampling& table, const double (&wi)[3], const double (&xi)[3],
          double (&wo)[3]) {
  const Direction drawn = table.draw({wi[0], wi[1], wi[2]}, xi[0], xi[1], xi[2]);
  std::copy(drawn.begin(), drawn.end(), wo);
}

double density(const TableSampling& table, const double (&wi)[3], const double (&wo)[3]) {
  return table.density({wi[0], wi[1], wi[2]}, {wo[0], wo[1], wo[2]});
}

}  // namespace merl

extern const PartModel kMerlModel;
const PartModel kMerlModel{merl::kDescription, merl::kKinds, {}, &merl::read};

Part merl_part(std::shared_ptr<const MeasuredTable> table, Interpolation interpolation) {
  const bool linear = interpolation == Interpolation::linear;
  const std::size_t kind = linear ? 0 : 1;
  const HoleMap& holes = table->holes();
  const auto& bits = linear ? holes.around : holes.cells;
  const std::size_t bytes = MeasuredTable::kCells * MeasuredTable::kChannels * sizeof(float) +
                            2 * bits.size() * sizeof(std::uint64_t);
  const merl::Constants constants{table->data(), bits.empty() ? nullptr : bits.data()};
  auto owner = std::make_shared<const merl::Owner>(merl::Owner{constants, std::move(table)});
  return {&merl::kKinds[kind],
          {std::move(owner), bytes},
          std::make_shared<const CheckedLobe>(CheckedLobe{&kMerlModel.description, kind, {}}),
          MeasuredTable::kChannels};
}

}  // namespace gonio
