#include "client/request_head.h"

#include "client/convert.h"
#include "gonio/v1/evaluate.pb.h"
#include "wire/fields.h"

namespace gonio::client {

RequestHead::RequestHead(const Material& material, Precision precision,
                         InstructionSet instruction_set)
    : precision_(precision) {
  using Wire = gonio::v1::EvaluateRequest;
  wire::put_header(bytes_, Wire::kMaterialFieldNumber, material.wire().size());
  bytes_ += material.wire();
  material_bytes_ = bytes_.size();
  Wire options;
  options.set_precision(to_wire(precision));
  options.set_instruction_set(to_wire(instruction_set));
  options.AppendToString(&bytes_);
}

}  // namespace gonio::client
