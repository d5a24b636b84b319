#include "client/messages/fit_convert.h"

#include <utility>

#include "client/messages/message_json.h"
#include "wire/mapping/certificate.h"

namespace gonio::client {

FitProgress progress_of(const gonio::v1::FitProgress& progress) {
  return wire::from_message<FitProgress>(progress).value();  // of numbers and texts alone
}

Result<FitResult> fit_result_of(const gonio::v1::FitResult& result) {
  auto material = material_of(result.material());
  if (!material) return material.error();
  auto json = json_of(result);
  if (!json) return json.error();
  auto certificate = wire::from_message<FitCertificate>(result.certificate());
  if (!certificate) return certificate.error();
  return FitResult{std::move(*material), std::move(*certificate), std::move(*json)};
}

}  // namespace gonio::client
