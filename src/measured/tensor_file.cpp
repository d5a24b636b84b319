#include "measured/tensor_file.h"

#include <bit>
#include <cstring>
#include <utility>

#include "measured/file_error.h"

namespace gonio {
namespace {

static_assert(std::endian::native == std::endian::little, "tensor files are little-endian");

constexpr std::string_view kMagic("tensor_file\0\1\0", 14);
constexpr std::uint32_t kMostFields = 1000;
constexpr std::uint16_t kMostDimensions = 8;
constexpr std::uint8_t kByte = 1, kFloat = 10;  // types of numbers

// The number at `at`, which moves on; false at the end.
template <class T>
bool take(std::string_view bytes, std::size_t& at, T& number) {
  if (bytes.size() - at < sizeof(T)) return false;
  std::memcpy(&number, bytes.data() + at, sizeof(T));
  at += sizeof(T);
  return true;
}

}  // namespace

Error TensorFile::error(const std::string& found, const std::string& expected) const {
  return file_error(ErrorCode::data_loss, name_, found, expected);
}

Outcome TensorFile::read_field(std::size_t& at) {
  const auto early = [this] { return error("its end within the list of fields", "a whole list"); };
  std::uint16_t length = 0, dimensions = 0;
  if (!take(bytes_, at, length) || bytes_.size() - at < length) return early();
  std::string name(bytes_.substr(at, length));
  at += length;
  Field field;
  if (!take(bytes_, at, dimensions) || !take(bytes_, at, field.type) ||
      !take(bytes_, at, field.offset))
    return early();
  if (dimensions > kMostDimensions) {
    return error("a field of " + std::to_string(dimensions) + " dimensions",
                 "at most " + std::to_string(kMostDimensions));
  }
  field.shape.resize(dimensions);
  for (std::uint64_t& size : field.shape) {
    if (!take(bytes_, at, size)) return early();
  }
  fields_.insert_or_assign(std::move(name), std::move(field));
  return Ok{};
}

Result<TensorFile> TensorFile::parse(std::string_view bytes, std::string name) {
  TensorFile file(bytes, std::move(name));
  if (bytes.substr(0, kMagic.size()) != kMagic)
    return file.error("'" + std::string(bytes.substr(0, kMagic.size())) + "' at its beginning",
                      "`tensor_file`, version 1.0");
  std::size_t at = kMagic.size();
  std::uint32_t count = 0;
  if (!take(bytes, at, count)) return file.error("its end after the first bytes", "fields");
  if (count > kMostFields)
    return file.error(std::to_string(count) + " fields", "at most " + std::to_string(kMostFields));
  for (std::uint32_t i = 0; i < count; ++i) {
    if (const auto read = file.read_field(at); !read) return read.error();
  }
  return file;
}

Result<std::string_view> TensorFile::contents(const std::string& name, std::uint8_t type,
                                              std::size_t dimensions, std::size_t size) const {
  const auto found = fields_.find(name);
  if (found == fields_.end()) return error("no field '" + name + "'", "one");
  const Field& field = found->second;
  if (field.type != type || field.shape.size() != dimensions) {
    return error("field '" + name + "' of type " + std::to_string(field.type) + " and " +
                     std::to_string(field.shape.size()) + " dimensions",
                 "type " + std::to_string(type) + " and " + std::to_string(dimensions));
  }
  // A product that is too large for the file stops before it can overflow.
  std::uint64_t count = 1;
  bool fits = field.offset <= bytes_.size();
  for (const std::uint64_t extent : field.shape) {
    fits = fits && extent > 0 && extent <= (bytes_.size() - field.offset) / size / count;
    if (!fits) break;
    count *= extent;
  }
  if (!fits) return error("field '" + name + "' empty or beyond the file's end", "a whole file");
  return bytes_.substr(field.offset, count * size);
}

Result<TensorFile::Tensor> TensorFile::floats(const std::string& field,
                                              std::size_t dimensions) const {
  const auto bytes = contents(field, kFloat, dimensions, sizeof(float));
  if (!bytes) return bytes.error();
  Tensor tensor{fields_.at(field).shape, std::vector<float>(bytes->size() / sizeof(float))};
  std::memcpy(tensor.values.data(), bytes->data(), bytes->size());
  return tensor;
}

Result<std::uint8_t> TensorFile::byte(const std::string& field) const {
  const auto bytes = contents(field, kByte, 1, 1);
  if (!bytes) return bytes.error();
  if (bytes->size() != 1)
    return error("field '" + field + "' of " + std::to_string(bytes->size()) + " bytes", "one");
  return static_cast<std::uint8_t>(bytes->front());
}

}  // namespace gonio
