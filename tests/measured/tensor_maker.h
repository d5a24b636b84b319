// Tensor files put together by hand.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace gonio::testing {

class TensorMaker {
 public:
  void add(const std::string& name, std::uint8_t type, const std::vector<std::uint64_t>& shape,
           const void* data, std::size_t bytes) {
    fields_.push_back({name, type, shape, std::string(static_cast<const char*>(data), bytes)});
  }
  void add(const std::string& name, const std::vector<std::uint64_t>& shape,
           const std::vector<float>& values) {
    add(name, 10, shape, values.data(), values.size() * sizeof(float));
  }

  [[nodiscard]] std::string bytes() const {
    std::string head("tensor_file\0\1\0", 14), body;
    put(head, static_cast<std::uint32_t>(fields_.size()));
    std::size_t length = head.size();
    for (const Field& f : fields_) length += 13 + f.name.size() + 8 * f.shape.size();
    for (const Field& f : fields_) {
      put(head, static_cast<std::uint16_t>(f.name.size()));
      head += f.name;
      put(head, static_cast<std::uint16_t>(f.shape.size()));
      put(head, f.type);
      put(head, static_cast<std::uint64_t>(length + body.size()));
      for (const std::uint64_t size : f.shape) put(head, size);
      body += f.data;
    }
    return head + body;
  }

 private:
  struct Field {
    std::string name;
    std::uint8_t type;
    std::vector<std::uint64_t> shape;
    std::string data;
  };

  template <class T>
  static void put(std::string& to, T number) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    to.append(bytes, sizeof(T));
  }

  std::vector<Field> fields_;
};

}  // namespace gonio::testing
