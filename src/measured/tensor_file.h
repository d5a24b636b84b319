// The container of the RGL material database: named arrays of numbers in one file.
//
// Layout, little-endian: `tensor_file` and a zero byte; two bytes of version (1, 0); the number of
// fields (u32); for each field the length of its name (u16), the name, the number of its dimensions
// (u16), the type of its numbers (u8), where they begin (u64) and its dimensions (u64 each).
// Thread safety: plain data.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"

namespace gonio {

class TensorFile {
 public:
  struct Tensor {
    std::vector<std::uint64_t> shape;
    std::vector<float> values;  // the last dimension runs fastest
  };

  // `bytes` is a whole file, which must outlive the object, `name` what errors call it. Errors:
  // data_loss for what is no such file or ends early.
  static Result<TensorFile> parse(std::string_view bytes, std::string name);

  [[nodiscard]] bool has(const std::string& field) const { return fields_.count(field) != 0; }
  // Numbers of type float32. Errors: data_loss for a field that is absent, has another number of
  // dimensions or another type, or does not lie within the file.
  [[nodiscard]] Result<Tensor> floats(const std::string& field, std::size_t dimensions) const;
  // A field of one byte.
  [[nodiscard]] Result<std::uint8_t> byte(const std::string& field) const;

  [[nodiscard]] Error error(const std::string& found, const std::string& expected) const;

 private:
  struct Field {
    std::uint8_t type = 0;
    std::uint64_t offset = 0;
    std::vector<std::uint64_t> shape;
  };

  TensorFile(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}
  Outcome read_field(std::size_t& at);
  // The bytes of a field whose numbers take `size` each.
  [[nodiscard]] Result<std::string_view> contents(const std::string& name, std::uint8_t type,
                                                  std::size_t dimensions, std::size_t size) const;

  std::string_view bytes_;
  std::string name_;
  std::map<std::string, Field> fields_;
};

}  // namespace gonio
