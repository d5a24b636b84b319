// Requests from their bytes. Thread safety: a function without state.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>

#include "gonio/base/result.h"
#include "wire/bytes.h"
#include "wire/fields.h"
#include "wire/material_size.h"
#include "wire/message.h"

namespace gonio::server {

// Parses what has come; `materials` are the numbers of the fields that hold materials. Errors:
// invalid_argument for bytes that are not such a message, and for materials that are too large:
// parsed they take many times their bytes.
template <class Message>
Result<Message> decode_request(const grpc::ByteBuffer& buffer,
                               std::initializer_list<int> materials) {
  const auto bytes = wire::SliceBytes::of(buffer);
  wire::FieldReader fields(bytes, {0, bytes.size()});
  std::size_t size = 0;
  for (wire::Field field; fields.next(field);) {
    const bool material = std::any_of(materials.begin(), materials.end(), [&](int number) {
      return field.is(number, wire::WireType::bytes);
    });
    if (material) size += field.value.size();
  }
  if (auto small = wire::check_material_size(size); !small) return small.error();
  grpc::ByteBuffer copy(buffer);  // of references
  Message request;
  if (!fields.ok() || !wire::from_buffer(copy, request))
    return bad_value("request", "not a " + request.GetTypeName(), "the bytes of one");
  return request;
}

// A number of a request that is 0 where it is not given: the option's default stays.
template <class T, class From>
void set_if_given(T& option, From given) {
  if (given != From{0}) option = static_cast<T>(given);
}

}  // namespace gonio::server
