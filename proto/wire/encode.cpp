#include <array>
#include <string>
#include <vector>

#include "wire/codec.h"
#include "wire/fields.h"
#include "wire/numbers.h"

namespace gonio::wire {
namespace {

using Numbers = StreamNumbers;

// Small parts are gathered into one slice, large ones are passed on by reference.
class Gather {
 public:
  Gather() { text_.reserve(kWorthASlice); }

  std::string& text() { return text_; }

  // A packed array; an empty one is left out, as the generated code does.
  void add_array(std::uint32_t number, const grpc::Slice& slice) {
    if (slice.size() == 0) return;
    put_header(text_, number, slice.size());
    if (slice.size() < kWorthASlice) {
      text_.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
      return;
    }
    flush();
    slices_.push_back(slice);
  }

  grpc::ByteBuffer finish() {
    flush();
    return {slices_.data(), slices_.size()};
  }

 private:
  static constexpr std::size_t kWorthASlice = 1024;  // bytes; below, a copy costs less

  void flush() {
    if (!text_.empty()) slices_.emplace_back(text_);
    text_.clear();
  }

  std::string text_;
  std::vector<grpc::Slice> slices_;
};

std::size_t array_size(std::uint32_t number, const grpc::Slice& slice) {
  return slice.size() == 0 ? 0 : header_size(number, slice.size()) + slice.size();
}

// The fields of the arrays, or the field of the message that holds them.
std::size_t content_size(const RequestArrays& arrays) {
  std::size_t size = 0;
  for (const auto& one : arrays.arrays) size += array_size(one.number, one.data);
  return size;
}

std::size_t size_of(const RequestArrays& arrays) {
  const std::size_t content = content_size(arrays);
  return arrays.within == 0 ? content : header_size(arrays.within, content) + content;
}

void add_request(Gather& out, std::string_view head, const RequestArrays& arrays) {
  out.text() += head;
  if (arrays.within != 0) put_header(out.text(), arrays.within, content_size(arrays));
  for (const auto& one : arrays.arrays) out.add_array(one.number, one.data);
}

// In the order of their numbers, as the generated code has them.
template <class Head>
std::array<RequestArrays::One, 4> arrays_of(const ResponsePartsOf<Head>& parts) {
  constexpr ArrayNumbers kNumbers = array_numbers<Head>();
  return {{{kNumbers.flags, parts.flags},
           {kNumbers.values.of(parts.is_f64), parts.values},
           {kNumbers.pdf.of(parts.is_f64), parts.pdf},
           {kNumbers.wo.of(parts.is_f64), parts.wo}}};
}

void put_number(std::string& out, std::uint32_t number, std::uint64_t value) {
  if (value == 0) return;
  put_tag(out, number, WireType::varint);
  put_varint(out, value);
}

}  // namespace

RequestArrays::RequestArrays(const PairSlices& pairs)
    : within(pairs.is_f64 ? gonio::v1::EvaluateRequest::kPairsF64FieldNumber
                          : gonio::v1::EvaluateRequest::kPairsFieldNumber),
      arrays{{{gonio::v1::Pairs::kWiFieldNumber, pairs.wi},
              {gonio::v1::Pairs::kWoFieldNumber, pairs.wo}}} {
  using gonio::v1::Pairs, gonio::v1::PairsF64;
  static_assert(static_cast<int>(Pairs::kWiFieldNumber) == PairsF64::kWiFieldNumber);
  static_assert(static_cast<int>(Pairs::kWoFieldNumber) == PairsF64::kWoFieldNumber);
}

RequestArrays::RequestArrays(const SampleSlices& samples) {
  using Wire = gonio::v1::SampleRequest;
  constexpr std::uint32_t kWi[] = {Wire::kWiFieldNumber, Wire::kWiF64FieldNumber};
  constexpr std::uint32_t kXi[] = {Wire::kXiFieldNumber, Wire::kXiF64FieldNumber};
  const std::size_t type = samples.is_f64 ? 1 : 0;
  arrays = {{{kWi[type], samples.wi}, {kXi[type], samples.xi}}};
}

grpc::ByteBuffer encode_request(std::string_view head, const RequestArrays& arrays) {
  Gather out;
  add_request(out, head, arrays);
  return out.finish();
}

grpc::ByteBuffer encode_stream_request(std::uint64_t sequence, std::uint32_t slot,
                                       std::string_view head, const RequestArrays& arrays) {
  Gather out;
  put_number(out.text(), Numbers::kSequence, sequence);
  put_number(out.text(), Numbers::kSlot, slot);
  put_header(out.text(), Numbers::kRequest, head.size() + size_of(arrays));
  add_request(out, head, arrays);
  return out.finish();
}

template <class Head>
grpc::ByteBuffer encode_response(const ResponsePartsOf<Head>& parts) {
  Gather out;
  out.text() += parts.head.SerializeAsString();
  for (const auto& [number, data] : arrays_of(parts)) out.add_array(number, data);
  return out.finish();
}

grpc::ByteBuffer encode_response(const gonio::v1::IntegrateResponse& response) {
  const grpc::Slice slice(response.SerializeAsString());
  return {&slice, 1};
}

template <class Head>
grpc::ByteBuffer encode_stream_response(std::uint64_t sequence,
                                        const ResponsePartsOf<Head>& parts) {
  const std::string head = parts.head.SerializeAsString();
  const auto arrays = arrays_of(parts);
  std::size_t size = head.size();
  for (const auto& [number, data] : arrays) size += array_size(number, data);
  Gather out;
  put_number(out.text(), Numbers::kSequence, sequence);
  put_header(out.text(), Numbers::kAnswer, size);
  out.text() += head;
  for (const auto& [number, data] : arrays) out.add_array(number, data);
  return out.finish();
}

grpc::ByteBuffer encode_stream_error(std::uint64_t sequence, const gonio::v1::ErrorDetail& error) {
  const std::string content = error.SerializeAsString();
  Gather out;
  put_number(out.text(), Numbers::kSequence, sequence);
  put_header(out.text(), Numbers::kError, content.size());
  out.text() += content;
  return out.finish();
}

template grpc::ByteBuffer encode_response(const ResponseParts&);
template grpc::ByteBuffer encode_response(const SampleResponseParts&);
template grpc::ByteBuffer encode_stream_response(std::uint64_t, const ResponseParts&);
template grpc::ByteBuffer encode_stream_response(std::uint64_t, const SampleResponseParts&);

}  // namespace gonio::wire
