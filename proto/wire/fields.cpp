#include "wire/fields.h"

namespace gonio::wire {

bool FieldReader::fail() {
  ok_ = false;
  return false;
}

bool FieldReader::read_byte(std::uint8_t& byte) {
  if (at_ >= end_) return false;
  if (piece_.size == 0) piece_ = bytes_.piece(at_);
  byte = *piece_.data;
  ++piece_.data;
  --piece_.size;
  ++at_;
  return true;
}

bool FieldReader::read_varint(std::uint64_t& value) {
  value = 0;
  std::uint8_t byte = 0;
  for (unsigned shift = 0; shift < 64; shift += 7) {
    if (!read_byte(byte)) return false;
    value |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
    if ((byte & 0x80) == 0) return true;
  }
  return false;  // longer than ten bytes
}

bool FieldReader::read_value(Field& field) {
  std::uint64_t length = 0;
  switch (field.type) {
    case WireType::varint:
      field.value.begin = at_;
      if (!read_varint(field.varint)) return false;
      field.value.end = at_;
      return true;
    case WireType::fixed64:
      length = 8;
      break;
    case WireType::fixed32:
      length = 4;
      break;
    case WireType::bytes:
      if (!read_varint(length)) return false;
      break;
    default:
      return false;  // a group, or a type that does not exist
  }
  if (length > end_ - at_) return false;
  field.value = {at_, at_ + length};
  at_ = field.value.end;
  piece_ = {};
  return true;
}

bool FieldReader::next(Field& field) {
  if (!ok_ || at_ >= end_) return false;
  field.whole.begin = at_;
  std::uint64_t tag = 0;
  if (!read_varint(tag) || tag > UINT32_MAX || (tag >> 3) == 0) return fail();
  field.number = static_cast<std::uint32_t>(tag >> 3);
  field.type = static_cast<WireType>(tag & 7);
  if (!read_value(field)) return fail();
  field.whole.end = at_;
  return true;
}

void put_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>((value & 0x7F) | 0x80));
  out.push_back(static_cast<char>(value));
}

void put_tag(std::string& out, std::uint32_t number, WireType type) {
  put_varint(out, (std::uint64_t{number} << 3) | static_cast<std::uint64_t>(type));
}

void put_header(std::string& out, std::uint32_t number, std::size_t length) {
  put_tag(out, number, WireType::bytes);
  put_varint(out, length);
}

std::size_t header_size(std::uint32_t number, std::size_t length) {
  std::string header;
  put_header(header, number, length);
  return header.size();
}

}  // namespace gonio::wire
