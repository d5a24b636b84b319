#include "measured/file_error.h"

#include <utility>

#include "gonio/base/shown.h"

namespace gonio {

Error file_error(ErrorCode code, std::string_view where, std::string_view found,
                 std::string expected) {
  Error error{code, {}, shown(where), shown(found), std::move(expected)};
  error.message = error.field + ": found " + error.value + "; expected " + error.allowed;
  return error;
}

}  // namespace gonio
