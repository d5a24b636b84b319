#include <initializer_list>
#include <string>
#include <vector>

#include "wire/codec.h"
#include "wire/fields.h"

namespace gonio::wire {
namespace {

using gonio::v1::EvaluateRequest;
using gonio::v1::EvaluateResponse;

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

using WirePairs = gonio::v1::Pairs;  // PairsF64 has the same numbers
static_assert(static_cast<int>(WirePairs::kWiFieldNumber) == gonio::v1::PairsF64::kWiFieldNumber);
static_assert(static_cast<int>(WirePairs::kWoFieldNumber) == gonio::v1::PairsF64::kWoFieldNumber);

std::size_t pairs_size(const PairSlices& pairs) {
  return array_size(WirePairs::kWiFieldNumber, pairs.wi) +
         array_size(WirePairs::kWoFieldNumber, pairs.wo);
}

std::uint32_t pairs_number(const PairSlices& pairs) {
  return pairs.is_f64 ? EvaluateRequest::kPairsF64FieldNumber : EvaluateRequest::kPairsFieldNumber;
}

void add_request(Gather& out, std::string_view head, const PairSlices* pairs) {
  out.text() += head;
  if (pairs == nullptr) return;
  put_header(out.text(), pairs_number(*pairs), pairs_size(*pairs));
  out.add_array(WirePairs::kWiFieldNumber, pairs->wi);
  out.add_array(WirePairs::kWoFieldNumber, pairs->wo);
}

std::uint32_t values_number(const ResponseParts& parts) {
  return parts.is_f64 ? EvaluateResponse::kValuesF64FieldNumber
                      : EvaluateResponse::kValuesFieldNumber;
}

void add_response(Gather& out, const std::string& head, const ResponseParts& parts) {
  out.text() += head;
  out.add_array(EvaluateResponse::kFlagsFieldNumber, parts.flags);
  out.add_array(values_number(parts), parts.values);
}

void put_number(std::string& out, std::uint32_t number, std::uint64_t value) {
  if (value == 0) return;
  put_tag(out, number, WireType::varint);
  put_varint(out, value);
}

}  // namespace

grpc::ByteBuffer encode_request(std::string_view head, const PairSlices* pairs) {
  Gather out;
  add_request(out, head, pairs);
  return out.finish();
}

grpc::ByteBuffer encode_stream_request(std::uint64_t sequence, std::uint32_t slot,
                                       std::string_view head, const PairSlices* pairs) {
  using Wire = gonio::v1::EvaluateStreamRequest;
  std::size_t size = head.size();
  if (pairs != nullptr) {
    const std::size_t content = pairs_size(*pairs);
    size += header_size(pairs_number(*pairs), content) + content;
  }
  Gather out;
  put_number(out.text(), Wire::kSequenceFieldNumber, sequence);
  put_number(out.text(), Wire::kSlotFieldNumber, slot);
  put_header(out.text(), Wire::kEvaluateFieldNumber, size);
  add_request(out, head, pairs);
  return out.finish();
}

grpc::ByteBuffer encode_response(const ResponseParts& parts) {
  Gather out;
  add_response(out, parts.head.SerializeAsString(), parts);
  return out.finish();
}

grpc::ByteBuffer encode_stream_response(std::uint64_t sequence, const ResponseParts& parts) {
  using Wire = gonio::v1::EvaluateStreamResponse;
  const std::string head = parts.head.SerializeAsString();
  const std::size_t size = head.size() +
                           array_size(EvaluateResponse::kFlagsFieldNumber, parts.flags) +
                           array_size(values_number(parts), parts.values);
  Gather out;
  put_number(out.text(), Wire::kSequenceFieldNumber, sequence);
  put_header(out.text(), Wire::kEvaluateFieldNumber, size);
  add_response(out, head, parts);
  return out.finish();
}

grpc::ByteBuffer encode_stream_error(std::uint64_t sequence, const gonio::v1::ErrorDetail& error) {
  using Wire = gonio::v1::EvaluateStreamResponse;
  const std::string content = error.SerializeAsString();
  Gather out;
  put_number(out.text(), Wire::kSequenceFieldNumber, sequence);
  put_header(out.text(), Wire::kErrorFieldNumber, content.size());
  out.text() += content;
  return out.finish();
}

}  // namespace gonio::wire
