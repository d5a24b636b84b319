// What all requests of one evaluation have in common, as the bytes that are sent. Internal to the
// client library.
//
// A material is serialised once, when it is made; a request takes its bytes as they are. Thread
// safety: plain values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "client/material.h"
#include "client/types.h"

namespace gonio::client {

class RequestHead {
 public:
  RequestHead(const Material& material, Precision precision, InstructionSet instruction_set);

  [[nodiscard]] Precision precision() const { return precision_; }

  // A gonio.v1.EvaluateRequest without directions, serialised.
  [[nodiscard]] std::string_view with_material() const { return bytes_; }
  [[nodiscard]] std::string_view without_material() const {
    return std::string_view(bytes_).substr(material_bytes_);
  }

 private:
  std::string bytes_;
  std::size_t material_bytes_ = 0;  // at the start of bytes_
  Precision precision_;
};

}  // namespace gonio::client
