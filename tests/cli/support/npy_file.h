// NPY files as NumPy writes them, and as it does not.
#pragma once

#include <cstring>
#include <string>
#include <vector>

namespace gonio::test {

inline std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                       const std::string& data) {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  header.resize(117, ' ');
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + "\n" + data;
}

template <class T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

}  // namespace gonio::test
