#include "server/messages/fit_messages.h"

#include "server/messages/material_message.h"
#include "wire/mapping/certificate.h"

namespace gonio::server {

v1::FitResult to_wire(const fit::FitResult& result) {
  v1::FitResult to;
  *to.mutable_material() = to_wire(result.material);
  *to.mutable_certificate() = wire::to_message(result.certificate);
  return to;
}

}  // namespace gonio::server
