#include "gonio/base/result.h"

#include "gonio/base/shown.h"

namespace gonio {

Error bad_value(std::string_view field, std::string_view value, std::string_view allowed,
                ErrorCode code) {
  Error error{.code = code,
              .message = {},
              .field = shown(field, kQuotedLength),
              .value = shown(value, kQuotedLength),
              .allowed = std::string(allowed)};
  error.message = error.field + " is " + error.value + "; allowed: " + error.allowed;
  return error;
}

}  // namespace gonio
