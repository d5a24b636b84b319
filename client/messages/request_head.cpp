#include "client/messages/request_head.h"

#include "client/messages/convert.h"
#include "gonio/v1/evaluate.pb.h"
#include "gonio/v1/sample.pb.h"
#include "wire/fields.h"

namespace gonio::client {
namespace {

template <class Wire>
Wire sampling(std::uint64_t per_wi, const NumberSource& numbers) {
  Wire request;
  request.set_per_wi(per_wi);
  request.set_sequence(to_wire(numbers.sequence));
  request.set_seed(numbers.seed);
  return request;
}

}  // namespace

template <class Wire>
RequestHead::RequestHead(const Material& material, Precision precision,
                         const EvaluateOptions& options, Wire rest)
    : precision_(precision) {
  wire::put_header(bytes_, Wire::kMaterialFieldNumber, material.wire().size());
  bytes_ += material.wire();
  material_bytes_ = bytes_.size();
  rest.set_precision(to_wire(precision));
  rest.set_instruction_set(to_wire(options.instruction_set));
  rest.AppendToString(&bytes_);
}

RequestHead RequestHead::evaluate(const Material& material, Precision precision,
                                  const EvaluateOptions& options) {
  gonio::v1::EvaluateRequest rest;
  rest.set_pdf(options.pdf);
  RequestHead head(material, precision, options, rest);
  head.wants_pdf_ = options.pdf;
  return head;
}

RequestHead RequestHead::sample(const Material& material, Precision precision,
                                const EvaluateOptions& options, std::uint64_t per_wi,
                                const NumberSource& numbers) {
  RequestHead head(material, precision, options,
                   sampling<gonio::v1::SampleRequest>(per_wi, numbers));
  head.method_ = &kSample;
  head.wants_pdf_ = true;
  return head;
}

RequestHead RequestHead::sample(const Material& material, Precision precision,
                                const EvaluateOptions& options, std::uint64_t per_wi) {
  gonio::v1::SampleRequest rest;
  rest.set_per_wi(per_wi);
  RequestHead head(material, precision, options, rest);
  head.method_ = &kSample;
  head.wants_pdf_ = true;
  return head;
}

RequestHead RequestHead::integrate(const Material& material, Precision precision,
                                   const EvaluateOptions& options, std::uint64_t per_wi,
                                   const NumberSource& numbers) {
  return {material, precision, options, sampling<gonio::v1::IntegrateRequest>(per_wi, numbers)};
}

}  // namespace gonio::client
