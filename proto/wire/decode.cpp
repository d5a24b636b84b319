#include <type_traits>
#include <utility>

#include "wire/codec.h"
#include "wire/fields.h"
#include "wire/material_size.h"
#include "wire/message.h"
#include "wire/numbers.h"
#include "wire/scan.h"

namespace gonio::wire {
namespace {

using Numbers = StreamNumbers;

// The generated message for each decoded type.
template <class Decoded>
struct MessageOf {
  using Type = typename Decoded::Message;
  static constexpr bool kIsRequest = requires(Decoded d) { d.material; };
};
template <>
struct MessageOf<StreamRequest> {
  using Type = gonio::v1::EvaluateStreamRequest;
  static constexpr bool kIsRequest = true;
};
template <>
struct MessageOf<SampleStreamRequest> {
  using Type = gonio::v1::SampleStreamRequest;
  static constexpr bool kIsRequest = true;
};
template <>
struct MessageOf<StreamResponse> {
  using Type = gonio::v1::EvaluateStreamResponse;
  static constexpr bool kIsRequest = false;
};
template <>
struct MessageOf<SampleStreamResponse> {
  using Type = gonio::v1::SampleStreamResponse;
  static constexpr bool kIsRequest = false;
};

Range all_of(const SliceBytes& bytes) { return {0, bytes.size()}; }

Error malformed(std::string_view message) {
  return {ErrorCode::invalid_argument, "the bytes received are not a " + std::string(message), "",
          "", ""};
}

template <class R>
bool scan(const SliceBytes& bytes, Range range, ChunkOf<R>& out);
template <class R>
bool scan(const SliceBytes& bytes, Range range, ChunkAnswerOf<R>& out);

// Reads the canonical form in place. Anything else is brought into it by the generated parser, the
// authority on what is legal; unknown fields are dropped on the way as any receiver may.
template <class Decoded>
Result<Decoded> decode_range(const SliceBytes& bytes, Range range) {
  using Of = MessageOf<Decoded>;
  Decoded decoded;
  if (scan(bytes, range, decoded)) return decoded;
  if constexpr (Of::kIsRequest) {
    const auto fit = check_material<Decoded>(bytes, range);
    if (!fit) return fit.error();
  }
  typename Of::Type message;
  if (!message.ParseFromString(bytes.text(range.begin, range.size())))
    return malformed(message.GetTypeName());
  message.DiscardUnknownFields();
  const SliceBytes canonical({grpc::Slice(to_bytes(message))});
  Decoded again;
  if (scan(canonical, all_of(canonical), again)) return again;
  return malformed(message.GetTypeName());
}

template <class R>
bool scan(const SliceBytes& bytes, Range range, ChunkOf<R>& out) {
  bool seen = false;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    if (field.is(Numbers::kSequence, WireType::varint)) {
      out.sequence = field.varint;
    } else if (field.is(Numbers::kSlot, WireType::varint)) {
      out.slot = static_cast<std::uint32_t>(field.varint);
    } else if (field.is(Numbers::kRequest, WireType::bytes) && !seen) {
      seen = true;
      out.request = decode_range<R>(bytes, field.value);
    } else {
      return false;
    }
  }
  return fields.ok();
}

template <class R>
bool scan(const SliceBytes& bytes, Range range, ChunkAnswerOf<R>& out) {
  bool seen = false;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field);) {
    if (field.is(Numbers::kSequence, WireType::varint)) {
      out.sequence = field.varint;
    } else if (field.is(Numbers::kAnswer, WireType::bytes) && !seen) {
      seen = true;
      auto response = decode_range<R>(bytes, field.value);
      if (!response) return false;
      out.result = std::move(*response);
    } else if (field.is(Numbers::kError, WireType::bytes) && !seen) {
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

}  // namespace

template <class Decoded>
Result<Decoded> decode(const grpc::ByteBuffer& buffer) {
  const SliceBytes bytes = SliceBytes::of(buffer);
  return decode_range<Decoded>(bytes, all_of(bytes));
}

template Result<Request> decode(const grpc::ByteBuffer&);
template Result<SampleRequest> decode(const grpc::ByteBuffer&);
template Result<IntegrateRequest> decode(const grpc::ByteBuffer&);
template Result<StreamRequest> decode(const grpc::ByteBuffer&);
template Result<SampleStreamRequest> decode(const grpc::ByteBuffer&);
template Result<Response> decode(const grpc::ByteBuffer&);
template Result<SampleResponse> decode(const grpc::ByteBuffer&);
template Result<StreamResponse> decode(const grpc::ByteBuffer&);
template Result<SampleStreamResponse> decode(const grpc::ByteBuffer&);

}  // namespace gonio::wire
