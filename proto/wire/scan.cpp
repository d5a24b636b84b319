#include "wire/scan.h"

#include <array>
#include <bit>

#include "wire/numbers.h"

namespace gonio::wire {
namespace {

static_assert(std::endian::native == std::endian::little,
              "packed floats are read as they lie in memory");

void append(const SliceBytes& bytes, Range range, std::string& to) {
  const std::size_t old = to.size();
  to.resize(old + range.size());
  bytes.copy(range.begin, range.size(), to.data() + old);
}

// A packed array that may occur once.
struct ArrayField {
  std::uint32_t number;
  std::size_t element;  // bytes
  Array array = {};
  bool seen = false;

  // False for arrays that are left to the generated parser: unpacked, repeated or broken ones.
  bool take(const Field& field) {
    if (seen || field.type != WireType::bytes || field.value.size() % element != 0) return false;
    seen = true;
    array = {field.value.begin, field.value.size() / element};
    return true;
  }
};

template <std::size_t N>
ArrayField* find(std::array<ArrayField, N>& arrays, std::uint32_t number) {
  for (ArrayField& array : arrays) {
    if (array.number == number) return &array;
  }
  return nullptr;
}

// A material that occurs twice is merged, which its concatenated bytes express.
void take_material(const SliceBytes& bytes, Range range, std::optional<std::string>& to) {
  append(bytes, range, to ? *to : to.emplace());
}

// Notes the places of a message's arrays and leaves its material, if there is one, as it is. The
// rest is small and goes to the generated parser.
template <std::size_t N, class Head>
bool scan_flat(const SliceBytes& bytes, Range range, std::array<ArrayField, N>& arrays, Head& head,
               std::optional<std::string>* material) {
  std::string rest;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    if (ArrayField* array = find(arrays, field.number)) {
      if (!array->take(field)) return false;
    } else if (material != nullptr && field.is(kMaterial, WireType::bytes)) {
      take_material(bytes, field.value, *material);
    } else {
      append(bytes, field.whole, rest);
    }
  }
  return fields.ok() && head.ParseFromString(rest);
}

bool scan_pairs(const SliceBytes& bytes, Range range, std::size_t element, Request& out) {
  using gonio::v1::Pairs;
  std::array<ArrayField, 2> arrays = {
      {{Pairs::kWiFieldNumber, element}, {Pairs::kWoFieldNumber, element}}};
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    ArrayField* array = find(arrays, field.number);
    if (array == nullptr || !array->take(field)) return false;
  }
  out.wi = arrays[0].array;
  out.wo = arrays[1].array;
  return fields.ok();
}

template <class Decoded>
bool scan_response(const SliceBytes& bytes, Range range, Decoded& out) {
  constexpr ArrayNumbers kNumbers = array_numbers<typename Decoded::Message>();
  constexpr std::size_t kF32 = sizeof(float), kF64 = sizeof(double);
  std::array<ArrayField, 7> arrays = {{{kNumbers.flags, 1},
                                       {kNumbers.values.f32, kF32},
                                       {kNumbers.pdf.f32, kF32},
                                       {kNumbers.wo.f32, kF32},
                                       {kNumbers.values.f64, kF64},
                                       {kNumbers.pdf.f64, kF64},
                                       {kNumbers.wo.f64, kF64}}};
  if (!scan_flat(bytes, range, arrays, out.head, nullptr)) return false;
  const bool any_f32 = arrays[1].seen || arrays[2].seen || arrays[3].seen;
  out.is_f64 = arrays[4].seen || arrays[5].seen || arrays[6].seen;
  if (any_f32 && out.is_f64) return false;
  const std::size_t first = out.is_f64 ? 4 : 1;
  out.flags = arrays[0].array;
  out.values = arrays[first].array;
  out.pdf = arrays[first + 1].array;
  out.wo = arrays[first + 2].array;
  out.bytes = bytes;
  return true;
}

}  // namespace

// Pairs given twice are left to the generated parser: it knows how a oneof merges.
bool scan(const SliceBytes& bytes, Range range, Request& out) {
  using Wire = gonio::v1::EvaluateRequest;
  std::string rest;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    const bool is_pairs = field.is(Wire::kPairsFieldNumber, WireType::bytes);
    const bool is_f64 = field.is(Wire::kPairsF64FieldNumber, WireType::bytes);
    const bool is_grid = field.is(Wire::kGridFieldNumber, WireType::bytes);
    if ((is_pairs || is_f64 || is_grid) && out.kind != Request::Kind::none) return false;
    if (field.is(kMaterial, WireType::bytes)) {
      take_material(bytes, field.value, out.material);
    } else if (is_pairs || is_f64) {
      out.kind = is_pairs ? Request::Kind::pairs : Request::Kind::pairs_f64;
      if (!scan_pairs(bytes, field.value, is_pairs ? sizeof(float) : sizeof(double), out))
        return false;
    } else {
      if (is_grid) out.kind = Request::Kind::grid;
      append(bytes, field.whole, rest);
    }
  }
  if (!fields.ok() || !out.head.ParseFromString(rest)) return false;
  out.bytes = bytes;
  return true;
}

bool scan(const SliceBytes& bytes, Range range, SampleRequest& out) {
  using Wire = gonio::v1::SampleRequest;
  std::array<ArrayField, 4> arrays = {{{Wire::kWiFieldNumber, sizeof(float)},
                                       {Wire::kWiF64FieldNumber, sizeof(double)},
                                       {Wire::kXiFieldNumber, sizeof(float)},
                                       {Wire::kXiF64FieldNumber, sizeof(double)}}};
  if (!scan_flat(bytes, range, arrays, out.head, &out.material)) return false;
  out.wi = arrays[0].array;
  out.wi_f64 = arrays[1].array;
  out.xi = arrays[2].array;
  out.xi_f64 = arrays[3].array;
  out.bytes = bytes;
  return true;
}

bool scan(const SliceBytes& bytes, Range range, IntegrateRequest& out) {
  using Wire = gonio::v1::IntegrateRequest;
  std::array<ArrayField, 2> arrays = {
      {{Wire::kWiFieldNumber, sizeof(float)}, {Wire::kWiF64FieldNumber, sizeof(double)}}};
  if (!scan_flat(bytes, range, arrays, out.head, &out.material)) return false;
  out.wi = arrays[0].array;
  out.wi_f64 = arrays[1].array;
  out.bytes = bytes;
  return true;
}

bool scan(const SliceBytes& bytes, Range range, Response& out) {
  return scan_response(bytes, range, out);
}
bool scan(const SliceBytes& bytes, Range range, SampleResponse& out) {
  return scan_response(bytes, range, out);
}

}  // namespace gonio::wire
