// Walks the fields of one protobuf message that lies in slices, and writes field headers.
//
// Knows the four wire types of proto3 (not groups). For anything else ok() is false, and the caller
// uses the generated parser. Format: protobuf.dev/programming-guides/encoding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "wire/bytes.h"

namespace gonio::wire {

enum class WireType : std::uint8_t { varint = 0, fixed64 = 1, bytes = 2, fixed32 = 5 };

struct Range {
  std::size_t begin = 0, end = 0;
  [[nodiscard]] std::size_t size() const { return end - begin; }
};

struct Field {
  std::uint32_t number = 0;
  WireType type = WireType::varint;
  Range whole;               // with its tag
  Range value;               // the content of a WireType::bytes
  std::uint64_t varint = 0;  // the value of a WireType::varint

  [[nodiscard]] bool is(std::uint32_t n, WireType t) const { return number == n && type == t; }
};

class FieldReader {
 public:
  // `bytes` must outlive the reader; `range` must lie within.
  FieldReader(const SliceBytes& bytes, Range range)
      : bytes_(bytes), at_(range.begin), end_(range.end) {}

  // False at the end, and where the bytes are not such a message.
  bool next(Field& field);
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  bool fail();
  bool read_value(Field& field);
  bool read_varint(std::uint64_t& value);
  bool read_byte(std::uint8_t& byte);

  const SliceBytes& bytes_;
  SliceBytes::Piece piece_;  // what lies together from at_ on
  std::size_t at_, end_;
  bool ok_ = true;
};

void put_varint(std::string& out, std::uint64_t value);
void put_tag(std::string& out, std::uint32_t number, WireType type);
// The tag and length of a WireType::bytes whose content follows.
void put_header(std::string& out, std::uint32_t number, std::size_t length);
std::size_t header_size(std::uint32_t number, std::size_t length);

}  // namespace gonio::wire
