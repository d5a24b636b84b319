#include <bit>
#include <type_traits>
#include <utility>

#include "wire/codec.h"
#include "wire/fields.h"
#include "wire/material_size.h"

namespace gonio::wire {
namespace {

static_assert(std::endian::native == std::endian::little,
              "packed floats are read as they lie in memory");

using gonio::v1::EvaluateRequest;
using gonio::v1::EvaluateResponse;

Range all_of(const SliceBytes& bytes) { return {0, bytes.size()}; }

void append(const SliceBytes& bytes, Range range, std::string& to) {
  const std::size_t old = to.size();
  to.resize(old + range.size());
  bytes.copy(range.begin, range.size(), to.data() + old);
}

// A packed array that is there at most once; false for what the generated parser should look at.
bool take_array(const Field& field, std::size_t element, Array& array, bool& seen) {
  if (seen || field.value.size() % element != 0) return false;
  seen = true;
  array = {field.value.begin, field.value.size() / element};
  return true;
}

bool scan_pairs(const SliceBytes& bytes, Range range, std::size_t element, Request& out) {
  bool seen_wi = false, seen_wo = false;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    if (field.is(gonio::v1::Pairs::kWiFieldNumber, WireType::bytes)) {
      if (!take_array(field, element, out.wi, seen_wi)) return false;
    } else if (field.is(gonio::v1::Pairs::kWoFieldNumber, WireType::bytes)) {
      if (!take_array(field, element, out.wo, seen_wo)) return false;
    } else {
      return false;  // unpacked, or unknown
    }
  }
  return fields.ok();
}

// The pairs are only noted, the material is left as it is; the rest is small and goes to the
// generated parser. Pairs given twice are left to it too: it knows how a oneof merges.
bool scan(const SliceBytes& bytes, Range range, Request& out) {
  std::string rest;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    const bool is_pairs = field.is(EvaluateRequest::kPairsFieldNumber, WireType::bytes);
    const bool is_f64 = field.is(EvaluateRequest::kPairsF64FieldNumber, WireType::bytes);
    const bool is_grid = field.is(EvaluateRequest::kGridFieldNumber, WireType::bytes);
    if ((is_pairs || is_f64 || is_grid) && out.kind != Request::Kind::none) return false;
    if (field.is(EvaluateRequest::kMaterialFieldNumber, WireType::bytes)) {
      // Given twice, the two merge: which is what their bytes in a row mean.
      append(bytes, field.value, out.material ? *out.material : out.material.emplace());
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

bool scan(const SliceBytes& bytes, Range range, Response& out) {
  std::string rest;
  bool seen_flags = false, seen_values = false;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    const bool is_f64 = field.is(EvaluateResponse::kValuesF64FieldNumber, WireType::bytes);
    if (field.is(EvaluateResponse::kFlagsFieldNumber, WireType::bytes)) {
      if (!take_array(field, 1, out.flags, seen_flags)) return false;
    } else if (is_f64 || field.is(EvaluateResponse::kValuesFieldNumber, WireType::bytes)) {
      out.is_f64 = is_f64;
      if (!take_array(field, is_f64 ? sizeof(double) : sizeof(float), out.values, seen_values))
        return false;
    } else {
      append(bytes, field.whole, rest);
    }
  }
  if (!fields.ok() || !out.head.ParseFromString(rest)) return false;
  // An unpacked array ends up in the head: let it be packed first.
  if (out.head.values_size() > 0 || out.head.values_f64_size() > 0) return false;
  out.bytes = bytes;
  return true;
}

Error malformed(std::string_view message) {
  return {ErrorCode::invalid_argument, "the bytes received are not a " + std::string(message), "",
          "", ""};
}

bool scan(const SliceBytes& bytes, Range range, StreamRequest& out);
bool scan(const SliceBytes& bytes, Range range, StreamResponse& out);

// Reads the canonical form in place. Anything else is brought into it by the generated parser, the
// authority on what is legal; unknown fields are dropped on the way as any receiver may.
template <class Message, class Decoded>
Result<Decoded> decode(const SliceBytes& bytes, Range range) {
  Decoded decoded;
  if (scan(bytes, range, decoded)) return decoded;
  if constexpr (!std::is_same_v<Decoded, Response> && !std::is_same_v<Decoded, StreamResponse>) {
    const auto fit = check_material<Decoded>(bytes, range);
    if (!fit) return fit.error();
  }
  Message message;
  if (!message.ParseFromString(bytes.text(range.begin, range.size())))
    return malformed(message.GetTypeName());
  message.DiscardUnknownFields();
  const SliceBytes canonical({grpc::Slice(message.SerializeAsString())});
  Decoded again;
  if (scan(canonical, all_of(canonical), again)) return again;
  return malformed(message.GetTypeName());
}

bool scan(const SliceBytes& bytes, Range range, StreamRequest& out) {
  using Wire = gonio::v1::EvaluateStreamRequest;
  bool seen = false;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    if (field.is(Wire::kSequenceFieldNumber, WireType::varint)) {
      out.sequence = field.varint;
    } else if (field.is(Wire::kSlotFieldNumber, WireType::varint)) {
      out.slot = static_cast<std::uint32_t>(field.varint);
    } else if (field.is(Wire::kEvaluateFieldNumber, WireType::bytes) && !seen) {
      seen = true;
      out.request = decode<EvaluateRequest, Request>(bytes, field.value);
    } else {
      return false;
    }
  }
  return fields.ok();
}

bool scan(const SliceBytes& bytes, Range range, StreamResponse& out) {
  using Wire = gonio::v1::EvaluateStreamResponse;
  bool seen = false;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    if (field.is(Wire::kSequenceFieldNumber, WireType::varint)) {
      out.sequence = field.varint;
    } else if (field.is(Wire::kEvaluateFieldNumber, WireType::bytes) && !seen) {
      seen = true;
      auto response = decode<EvaluateResponse, Response>(bytes, field.value);
      if (!response) return false;
      out.result = std::move(*response);
    } else if (field.is(Wire::kErrorFieldNumber, WireType::bytes) && !seen) {
      seen = true;
      gonio::v1::ErrorDetail detail;
      if (!detail.ParseFromString(bytes.text(field.value.begin, field.value.size()))) return false;
      out.result = std::move(detail);
    } else {
      return false;
    }
  }
  return fields.ok() && seen;
}

template <class Message, class Decoded>
Result<Decoded> decode(const grpc::ByteBuffer& buffer) {
  const SliceBytes bytes = SliceBytes::of(buffer);
  return decode<Message, Decoded>(bytes, all_of(bytes));
}

}  // namespace

Result<Request> decode_request(const grpc::ByteBuffer& buffer) {
  return decode<EvaluateRequest, Request>(buffer);
}

Result<StreamRequest> decode_stream_request(const grpc::ByteBuffer& buffer) {
  return decode<gonio::v1::EvaluateStreamRequest, StreamRequest>(buffer);
}

Result<Response> decode_response(const grpc::ByteBuffer& buffer) {
  return decode<EvaluateResponse, Response>(buffer);
}

Result<StreamResponse> decode_stream_response(const grpc::ByteBuffer& buffer) {
  return decode<gonio::v1::EvaluateStreamResponse, StreamResponse>(buffer);
}

}  // namespace gonio::wire
