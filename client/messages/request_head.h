// What all requests of one evaluation, or drawing of samples, have in common, as the bytes that are
// sent. Internal to the client library.
//
// A material is serialised once, when it is made; a request takes its bytes as they are. Thread
// safety: plain values.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "client/messages/answer.h"
#include "gonio/client/client.h"

namespace gonio::client {

class RequestHead {
 public:
  static RequestHead evaluate(const Material& material, Precision precision,
                              const EvaluateOptions& options);
  static RequestHead sample(const Material& material, Precision precision,
                            const EvaluateOptions& options, std::uint64_t per_wi,
                            const NumberSource& numbers);
  // For samples whose numbers go with them.
  static RequestHead sample(const Material& material, Precision precision,
                            const EvaluateOptions& options, std::uint64_t per_wi);
  static RequestHead integrate(const Material& material, Precision precision,
                               const EvaluateOptions& options, std::uint64_t per_wi,
                               const NumberSource& numbers);

  [[nodiscard]] Precision precision() const { return precision_; }
  [[nodiscard]] const Method& method() const { return *method_; }
  // What is to come back beside values and flags.
  [[nodiscard]] bool wants_pdf() const { return wants_pdf_; }
  [[nodiscard]] bool wants_wo() const { return method_ == &kSample; }

  // The request without its directions, serialised.
  [[nodiscard]] std::string_view with_material() const { return bytes_; }
  [[nodiscard]] std::string_view without_material() const {
    return std::string_view(bytes_).substr(material_bytes_);
  }

 private:
  // `rest`: what only this kind of request has.
  template <class Wire>
  RequestHead(const Material& material, Precision precision, const EvaluateOptions& options,
              Wire rest);

  std::string bytes_;
  std::size_t material_bytes_ = 0;  // at the start of bytes_
  Precision precision_;
  const Method* method_ = &kEvaluate;
  bool wants_pdf_ = false;
};

}  // namespace gonio::client
